// A failing case is made small for a limited time only.
#pragma once

namespace lgs::test {

/// Whether that time is over. Then whoever makes simpler cases need not go on.
bool isTimeUp();

}  // namespace lgs::test
