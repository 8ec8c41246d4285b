// Writes what the fuzzers start from: small good files of every format, one folder a format.
#include "common/image/files.h"
#include "common/stage/guard.h"

#include <cstring>
#include <vector>

namespace rasterlab {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& folder, const std::string& name, std::string_view bytes) {
  fs::create_directories(folder);
  write_file(folder / name, bytes);
}

Image<Rgb8> picture() {
  Image<Rgb8> image(5, 3);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      image(x, y) = {static_cast<std::uint8_t>(50 * x), static_cast<std::uint8_t>(80 * y), 7};
    }
  }
  return image;
}

void write_pictures(const fs::path& out) {
  for (const char* format : {"png", "jpg", "tga", "pnm", "pfm"}) {
    fs::create_directories(out / format);
  }
  const Image<Rgb8> image = picture();
  write_image(out / "png/a.png", image);
  write_image(out / "jpg/a.jpg", image);
  write_image(out / "tga/a.tga", image);
  write_image(out / "tga/b.tga", image, {.run_length = false});
  write_image(out / "pnm/a.ppm", image);
  write_image(out / "pnm/b.pgm", image, {.text = true});
  write_image(out / "pnm/c.pbm", image, {.text = true});
  write_image(out / "pfm/a.pfm", image);
}

void write_meshes(const fs::path& out) {
  write(out / "off", "a.off",
        "OFF\n4 2 0\n0 0 0 1 0 0 0 0\n1 0 0 0 1 0 1 0\n0 1 0 0 0 1 0 1\n1 1 0 1 1 1 1 1\n"
        "3 0 1 2\n3 1 3 2 255 0 0\n");
  write(out / "off", "b.off", "STCNOFF BINARY\n");
  write(out / "obj", "a.obj",
        "v 0 0 0 1 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 1\nvn 0 0 1\n"
        "f 1/1/1 2/2/1 3/1/1 -1/2/1\nf 1//1 \\\n2//1 3//1\n");
  write(out / "ply", "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nproperty uchar red\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n0 0 0 9\n1 0 0 9\n0 1 0 9\n3 0 1 2\n");
  write(out / "ply", "b.ply",
        "ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty float x\nelement face 0\n"
        "property list uchar int vertex_indices\nend_header\n");
  write(out / "stl", "a.stl",
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
        "endloop\nendfacet\nendsolid a\n");
  write(out / "stl", "b.stl",
        std::string(80, ' ') + std::string("\1\0\0\0", 4) + std::string(50, '\0'));
  write(out / "om", "a.om", std::string("OM\x54\x04\0\0\0\0\0\0\0\0\0\0\0\0", 16));
  const std::string one_vertex("OMT\x42\1\0\0\0\0\0\0\0\0\0\0\0", 16);
  const std::string position(12, '\0');
  write(out / "om", "b.om", one_vertex + std::string("\0\x16", 2) + position);
  write(out / "om", "named.om", one_vertex + std::string("\2\x16\1a", 4) + position);
}

void write_texts(const fs::path& out) {
  write(out / "scene", "a.scene",
        "cube.off\r\n0 0 -3\n0 0 0\n0 1 0\n# comment\n300\n64 48\n0.3\n1 2 -3 1 0.8\n0.2 0.8 0.6 "
        "20\n");
  write(out / "manifest", "a.json",
        R"({"stage": "01_lines", "exercises": [{"id": "01.1", "title": "A", "writes": ["01.1.png"]},
                                                {"id": "01.2", "title": "B", "points": 1}]})");
  write(out / "case", "a.json", R"({"family": "slivers", "numbers": ["0x1.8p+3", "-inf", "nan"]})");
  write(out / "rows", "a.txt", "0 0 3 4\n1 2 30 -4.5 255 0 0 # red\n1e3 2 3 4 0 0 0 1 2 3\n");
}

void write_floats(const fs::path& file, const std::vector<float>& floats) {
  std::string bytes(floats.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), floats.data(), bytes.size());
  write(file.parent_path(), file.filename(), bytes);
}

void write_triangles(const fs::path& out) {
  write_floats(out / "engine/corners", {-1, -1, 0, 1, 1, -1, 0, 1, 0, 1, 0, -0.5F});
  write_floats(out / "engine/matrix", {-1, -1, 0, 1, -1, 0, 0, 1, 0.5F,  // then column by column
                                       1,  0,  0, 0, 0,  1, 0, 0, 0,    0, 0.5F, 0.1F, 0, 0, 0, 1});
}

/// What the grader's judge reads: one record of each kind that bytes can spell, and one of numbers.
void write_results(const fs::path& out) {
  write(out / "results", "a.result",
        "RASTERLAB RESULT 1\npicture 2 1 3 0 0 0 picture\nabcdef\n"
        "coverage 3 1 1 0 0 0 pixels\n" +
            std::string("\1\0\0\2\1\0", 6) +
            "\ntext 0 0 1 3 0 0 words\nyes\n"
            "numbers 0 0 1 1 0.001 0 matrix\n" +
            std::string(8, '\0') + "\nend\n");
}

}  // namespace
}  // namespace rasterlab

int main(int argc, char** argv) {
  using namespace rasterlab;
  return run_guarded("make_seeds", [&] {
    if (argc != 2) throw UsageError("usage: make_seeds FOLDER");
    write_pictures(argv[1]);
    write_meshes(argv[1]);
    write_texts(argv[1]);
    write_triangles(argv[1]);
    write_results(argv[1]);
    return 0;
  });
}
