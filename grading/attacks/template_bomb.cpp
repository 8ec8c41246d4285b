// Keeps the compiler busy for ever.
#include "common/lines/draw_line.h"

template <int Depth, class... Types>
struct Bomb : Bomb<Depth - 1, Types..., Types...> {};
template <class... Types>
struct Bomb<0, Types...> {};
Bomb<30, int, int> bomb;

namespace rasterlab {

void draw_line(Image<Rgb8>&, const Point&, const Point&, const Rgb8&) {}

}  // namespace rasterlab
