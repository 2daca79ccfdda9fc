// The laws: each is a file in this folder, and a line here.
//
// A line has the name of the function that makes it, and of whom it is held. Of any engine of cells: segments, islands,
// history, lists of changes. Of one that takes regions: these. Of this library's alone: what only it shows.
#pragma once

#include "oracle/check/law.h"

namespace lgs::oracle::laws {

// clang-format off
#ifdef __wasm__  // the web's modules have no room for these
#define LGS_LAWS_OF_ROOM(law)
#else
#define LGS_LAWS_OF_ROOM(law)                                                                       \
  law(edges,     library)  /* 2: of any directed edges */                                           \
  law(shapes,    library)  /* circles, rectangles, thick lines */                                   \
  law(strokes,   library)  /* 10, and what is said of regions */                                    \
  law(memory,    library)  /* what goes leaves nothing */                                           \
  law(bytes,     library)  /* 7: bytes that are damaged, or of ill will */
#endif

#define LGS_LAWS(law)                                                                               \
  law(refusals,  library)  /* 7: what is refused changes nothing */                                 \
  law(handles,   library)  /* a handle of what is gone names nothing */                             \
  law(marks,     library)  /* a mark that the world rolled back beyond leads nowhere */             \
  law(brushes,   library)  /* 8 to 10: near to the exact result; what is not reached stays */       \
  law(changes,   library)  /* 6: the lists of changes, alone, keep a copy up to date */             \
  law(locality,  library)  /* 5: a commit changes what lies at the edits */                         \
  law(polygons,  library)  /* what stands reads as it was placed */                                 \
  law(cells,     library)  /* a copy of the cells that cellChanges() alone keeps up to date */      \
  law(loopView,  library)  /* 15: loops, also while chunks come and go */                           \
  law(views,     library)  /* 15: a view is its recompute */                                        \
  law(bodies,    library)  /* what is taken out of the ground, and foreseen */                      \
  law(ids,       any)      /* 6: of an engine that reports what changed: no id twice */             \
  law(regions,   regions)  /* 8: what strokes of other engines come to */                           \
  law(outline,   any)      /* 1 to 3 and 14: the references have the same segments, links, loops */ \
  law(islands,   any)      /* what hangs together */                                                \
  law(minimality, any)     /* 6: of an engine that reports what changed: it reports nothing else */ \
  law(questions, library)  /* questions about places are answered as the slow way answers them */   \
  law(twins,     library)  /* 4, 5: moved, turned, mirrored, cut */                                 \
  law(past,      library)  /* 12, 7: what was undone, or refused, has left no trace */              \
  LGS_LAWS_OF_ROOM(law)                                                                             \
  law(history,   any)      /* 4: how it came about does not matter; the last, as it begins anew */
// clang-format on

#define LGS_DECLARED(name, whose) std::unique_ptr<Law> name();
LGS_LAWS(LGS_DECLARED)
#undef LGS_DECLARED

}  // namespace lgs::oracle::laws
