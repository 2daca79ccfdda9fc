// What published.so exports.
#include "bench/published/published_engine.h"

extern "C" const lgs_engine_table* lgs_engine() { return lgs::bench::publishedEngine(); }
