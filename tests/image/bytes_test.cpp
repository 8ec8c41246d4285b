#include "common/image/bytes.h"

#include "common/image/check.h"

#include "tests/support/scratch.h"

#include <fstream>
#include <thread>

#include <gmock/gmock.h>
#include <sys/stat.h>

namespace rasterlab {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(stage01_files_whole, written_and_read) {
  const ScratchFolder folder;
  const std::string bytes("zero \0 and \r\n and \xff", 19);
  write_file(folder / "a.bin", bytes);
  EXPECT_EQ(read_file(folder / "a.bin"), bytes);
  write_file(folder / "a.bin", "");
  EXPECT_EQ(read_file(folder / "a.bin"), "");
  EXPECT_EQ(files_in(folder.path()), 1U);
}

TEST(stage01_files_whole, the_old_file_stays_until_the_new_is_whole) {
  const ScratchFolder folder;
  write_file(folder / "a.txt", "old");
  write_atomically(folder / "a.txt", [&](const fs::path& temporary) {
    EXPECT_EQ(temporary.parent_path(), folder.path());
    EXPECT_EQ(temporary.extension(), ".txt");
    std::ofstream(temporary) << "new";
    EXPECT_EQ(read_file(folder / "a.txt"), "old");
  });
  EXPECT_EQ(read_file(folder / "a.txt"), "new");
}

TEST(stage01_files_whole, what_throws_leaves_nothing) {
  const ScratchFolder folder;
  write_file(folder / "a.txt", "old");
  EXPECT_THROW(write_atomically(folder / "a.txt",
                                [](const fs::path& temporary) {
                                  std::ofstream(temporary) << "half";
                                  throw InputError("stop");
                                }),
               InputError);
  EXPECT_EQ(read_file(folder / "a.txt"), "old");
  EXPECT_EQ(files_in(folder.path()), 1U);
}

TEST(stage01_files_whole, permissions_are_those_of_a_new_file) {
  const ScratchFolder folder;
  std::ofstream(folder / "plain") << "x";
  write_file(folder / "atomic", "x");
  EXPECT_EQ(fs::status(folder / "plain").permissions(),
            fs::status(folder / "atomic").permissions());
}

TEST(stage01_files_whole, a_link_stays_a_link) {
  const ScratchFolder folder;
  write_file(folder / "target", "old");
  fs::create_symlink("target", folder / "link");
  write_file(folder / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(read_file(folder / "target"), "new");
}

TEST(stage01_files_whole, where_nothing_can_be_written) {
  const ScratchFolder folder;
  const auto error_of = [](const fs::path& path) -> std::string {
    try {
      write_file(path, "x");
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith(path.string()));
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(error_of(folder.path()), HasSubstr("it is a folder"));
  EXPECT_THAT(error_of(folder / "no/such/a.txt"), HasSubstr("there is no folder"));
  const std::string long_name(300, 'x');
  EXPECT_THAT(error_of(folder / long_name), HasSubstr("File name too long"));
  if (fs::exists("/dev/full")) {
    EXPECT_THAT(error_of("/dev/full"), HasSubstr("No space left"));
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
  }
}

TEST(stage01_files_whole, a_device_is_written_to_and_not_replaced) {
  write_file("/dev/null", "gone");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(stage01_files_whole, a_pipe_is_read_and_written) {
  const ScratchFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  std::thread writer([&] { write_file(folder / "pipe", "through"); });
  EXPECT_EQ(read_file(folder / "pipe"), "through");
  writer.join();
}

TEST(stage01_files_whole, many_at_once) {
  const ScratchFolder folder;
  std::vector<std::thread> threads;
  threads.reserve(8);
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back([&, i] {
      for (int j = 0; j < 50; ++j) write_file(folder / "a.txt", std::string(1000, char('a' + i)));
    });
  }
  for (std::thread& thread : threads) thread.join();
  const std::string bytes = read_file(folder / "a.txt");
  EXPECT_EQ(bytes, std::string(1000, bytes.at(0)));
  EXPECT_EQ(files_in(folder.path()), 1U);
}

}  // namespace
}  // namespace rasterlab
