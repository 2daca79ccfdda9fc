// The page without what is different from page to page. CMake makes it of page.html, the style and the scripts.
#pragma once

#include <string_view>

namespace lgs::oracle::paging {

/// Has the places {{title}}, {{report}} and {{data}}, in this order.
extern const std::string_view kTemplate;

}  // namespace lgs::oracle::paging
