// Which side of a surface is left out.
#pragma once

namespace rasterlab {

enum class Cull { none, back, front };

}  // namespace rasterlab
