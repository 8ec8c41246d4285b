#include "common/viewer/viewer.h"

namespace rasterlab {}
