#include "grading/judge/records.h"

#include "common/image/check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>

namespace rasterlab::grading {
namespace {

constexpr const char* first_line = "RASTERLAB RESULT 1";
constexpr std::uintmax_t max_file_size = std::uintmax_t{64} << 20U;
constexpr std::size_t max_records = 4096;
constexpr std::size_t max_name = 200;

constexpr std::array<const char*, 6> kind_names = {"picture", "values",  "coverage",
                                                   "segment", "numbers", "text"};

template <class Element>
void put_array(std::ostream& out, const std::vector<Element>& elements) {
  out.write(reinterpret_cast<const char*>(elements.data()),
            static_cast<std::streamsize>(elements.size() * sizeof(Element)));
}

/// Walks over the bytes of a result file.
class Reader {
 public:
  Reader(std::string bytes, std::string file) : bytes_(std::move(bytes)), file_(std::move(file)) {}

  std::string line() {
    const std::size_t end = bytes_.find('\n', at_);
    if (end == std::string::npos || end - at_ > 1000) fail("a line of at most 1000 characters");
    std::string text = bytes_.substr(at_, end - at_);
    at_ = end + 1;
    return text;
  }

  template <class Element>
  std::vector<Element> array(std::size_t count) {
    if (count > (bytes_.size() - at_) / sizeof(Element)) fail("more bytes");
    std::vector<Element> elements(count);
    if (count > 0) std::memcpy(elements.data(), bytes_.data() + at_, count * sizeof(Element));
    at_ += count * sizeof(Element);
    return elements;
  }

  bool finished() const { return at_ == bytes_.size(); }

  [[noreturn]] void fail(const std::string& expected) const {
    throw InputError(file_ + ": byte " + std::to_string(at_) + ": expected " + expected);
  }

 private:
  std::string bytes_;
  std::string file_;
  std::size_t at_ = 0;
};

std::string whole_file(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  std::error_code error;
  const auto status = std::filesystem::symlink_status(path, error);
  if (error || !std::filesystem::is_regular_file(status))
    throw InputError(name + ": expected a regular file");
  if (std::filesystem::file_size(path) > max_file_size)
    throw InputError(name + ": expected at most 64 MiB");
  std::ifstream in(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  if (!in) throw InputError(name + ": cannot be read");
  return std::move(bytes).str();
}

RecordKind kind_of(const std::string& name, const Reader& reader) {
  for (std::size_t i = 0; i < kind_names.size(); ++i) {
    if (name == kind_names[i]) return static_cast<RecordKind>(i);
  }
  reader.fail("the kind of a record");
}

/// What can be computed with in whole numbers.
bool is_coordinate(double number) {
  return std::abs(number) <= 1e6;
}

/// "KIND WIDTH HEIGHT CHANNELS COUNT TOLERANCE FREE NAME", then the bytes.
Record read_record(const std::string& header, Reader& reader) {
  std::istringstream fields(header);
  fields.imbue(std::locale::classic());
  Record record;
  std::string kind;
  std::size_t count = 0;
  if (!(fields >> kind >> record.width >> record.height >> record.channels >> count >>
        record.tolerance >> record.free_pixels) ||
      fields.get() != ' ' || !std::getline(fields, record.name) || record.name.size() > max_name) {
    reader.fail("a record's header");
  }
  record.kind = kind_of(kind, reader);
  if (record.channels != 1 && record.channels != 3) reader.fail("1 or 3 channels");
  if (record.width < 0 || record.height < 0 || record.width > 8192 || record.height > 8192)
    reader.fail("sides of 0 to 8192 pixels");
  const std::size_t pixels =
      static_cast<std::size_t>(record.width) * static_cast<std::size_t>(record.height);
  switch (record.kind) {
    case RecordKind::picture:
      record.bytes = reader.array<std::uint8_t>(pixels * static_cast<std::size_t>(record.channels));
      break;
    case RecordKind::values:
      record.numbers = reader.array<double>(pixels);
      break;
    case RecordKind::coverage:
      record.bytes = reader.array<std::uint8_t>(pixels);
      record.demands = reader.array<std::uint8_t>(pixels);
      break;
    case RecordKind::segment:
      record.ends = reader.array<double>(5);
      if (!std::all_of(record.ends.begin(), record.ends.end(), is_coordinate))
        reader.fail("a segment's ends within a million pixels");
      record.numbers = reader.array<double>(count);
      break;
    case RecordKind::numbers:
      record.numbers = reader.array<double>(count);
      break;
    case RecordKind::text: {
      const std::vector<char> text = reader.array<char>(count);
      record.text.assign(text.begin(), text.end());
      break;
    }
  }
  if (!reader.line().empty()) reader.fail("the end of the record");
  return record;
}

void write_record(std::ostream& out, const Record& record) {
  const std::size_t count =
      record.kind == RecordKind::text ? record.text.size() : record.numbers.size();
  out << kind_names[static_cast<std::size_t>(record.kind)] << ' ' << record.width << ' '
      << record.height << ' ' << record.channels << ' ' << count << ' ' << record.tolerance << ' '
      << record.free_pixels << ' ' << record.name << '\n';
  put_array(out, record.bytes);
  put_array(out, record.demands);
  put_array(out, record.ends);
  put_array(out, record.numbers);
  out << record.text << '\n';
}

}  // namespace

void Results::picture(const std::string& name, const Image<Rgb8>& image, int max_difference,
                      int free_pixels) {
  Record record{.name = name,
                .kind = RecordKind::picture,
                .width = image.width(),
                .height = image.height(),
                .channels = 3};
  record.tolerance = max_difference;
  record.free_pixels = free_pixels;
  for (const Rgb8& pixel : image.pixels())
    record.bytes.insert(record.bytes.end(), {pixel.r, pixel.g, pixel.b});
  records_.push_back(std::move(record));
}

void Results::picture(const std::string& name, const Image<std::uint8_t>& image, int max_difference,
                      int free_pixels) {
  Record record{
      .name = name, .kind = RecordKind::picture, .width = image.width(), .height = image.height()};
  record.tolerance = max_difference;
  record.free_pixels = free_pixels;
  record.bytes = image.pixels();
  records_.push_back(std::move(record));
}

void Results::values(const std::string& name, const Image<float>& image, double tolerance,
                     int free_pixels) {
  Record record{
      .name = name, .kind = RecordKind::values, .width = image.width(), .height = image.height()};
  record.tolerance = tolerance;
  record.free_pixels = free_pixels;
  record.numbers.assign(image.pixels().begin(), image.pixels().end());
  records_.push_back(std::move(record));
}

void Results::coverage(const std::string& name, const Image<std::uint8_t>& drawn,
                       const Image<std::uint8_t>& demands) {
  Record record{
      .name = name, .kind = RecordKind::coverage, .width = drawn.width(), .height = drawn.height()};
  record.bytes = drawn.pixels();
  record.demands = demands.pixels();
  records_.push_back(std::move(record));
}

void Results::segment(const std::string& name, const std::vector<Eigen::Vector2i>& pixels,
                      Eigen::Vector2i from, Eigen::Vector2i to, bool either_direction) {
  Record record{.name = name, .kind = RecordKind::segment};
  for (const Eigen::Vector2i& pixel : pixels)
    record.numbers.insert(record.numbers.end(), {double(pixel.x()), double(pixel.y())});
  record.ends = {double(from.x()), double(from.y()), double(to.x()), double(to.y()),
                 either_direction ? 1.0 : 0.0};
  records_.push_back(std::move(record));
}

void Results::numbers(const std::string& name, const std::vector<double>& numbers,
                      double tolerance) {
  Record record{.name = name, .kind = RecordKind::numbers};
  record.numbers = numbers;
  record.tolerance = tolerance;
  records_.push_back(std::move(record));
}

void Results::number(const std::string& name, double number, double tolerance) {
  numbers(name, {number}, tolerance);
}

void Results::text(const std::string& name, const std::string& text) {
  Record record{.name = name, .kind = RecordKind::text};
  record.text = text;
  records_.push_back(std::move(record));
}

void Results::write(const std::filesystem::path& path) const {
  std::ofstream out(path, std::ios::binary);
  out.imbue(std::locale::classic());
  out.precision(17);
  out << first_line << '\n';
  for (const Record& record : records_) write_record(out, record);
  out << "end\n";
  out.flush();
  if (!out) throw InputError(path.string() + ": cannot be written");
}

std::vector<Record> read_results(const std::filesystem::path& path) {
  Reader reader(whole_file(path), path.filename().string());
  if (reader.line() != first_line) reader.fail(std::string("the line ") + first_line);
  std::vector<Record> records;
  for (std::string header = reader.line(); header != "end"; header = reader.line()) {
    if (records.size() == max_records) reader.fail("at most 4096 records");
    records.push_back(read_record(header, reader));
  }
  if (!reader.finished()) reader.fail("the end of the file");
  return records;
}

}  // namespace rasterlab::grading
