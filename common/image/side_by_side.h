// side_by_side() is in operations.h.
#pragma once

#include "common/image/operations.h"
