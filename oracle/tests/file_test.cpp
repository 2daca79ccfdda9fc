// Files that are written: the old one or the new one, never a part of it, when the writer dies or the disk is full.
#include "oracle/trace/file.h"
#include "proptests/support/command.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>
#include <functional>

namespace lgs::oracle {
namespace {

namespace fs = std::filesystem;

class WrittenFile : public test::InAFolder {
 protected:
  std::string path(const std::string& name = "file") const { return InAFolder::path(name); }
  static std::string content(const std::string& file) { return readFile(file).value_or("(none)"); }
  std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(folder_), fs::directory_iterator()); }
};

TEST_F(WrittenFile, IsNewOrReplaced) {
  EXPECT_TRUE(writeFile(path(), "old"));
  EXPECT_EQ(content(path()), "old");
  ::chmod(path().c_str(), 0640);
  EXPECT_TRUE(writeFile(path(), ""));
  EXPECT_EQ(content(path()), "");
  struct stat status {};
  ASSERT_EQ(::stat(path().c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640U) << "who may read it stays";
  const ::mode_t mask = ::umask(027);
  EXPECT_TRUE(writeFile(path("new"), "x"));
  ::umask(mask);
  ASSERT_EQ(::stat(path("new").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640U);
  EXPECT_EQ(files(), 2) << "nothing else is left";
}

TEST_F(WrittenFile, ALinkStaysAndAFolderIsNone) {
  EXPECT_TRUE(writeFile(path(), "old"));
  fs::create_symlink("file", path("link"));
  EXPECT_TRUE(writeFile(path("link"), "new"));
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(content(path()), "new");
  EXPECT_FALSE(writeFile(folder_.string(), "x"));
  EXPECT_FALSE(tryToWrite(folder_.string()));
  EXPECT_FALSE(writeFile(path("none/file"), "x"));
  EXPECT_FALSE(tryToWrite(path("none/file")));
  EXPECT_TRUE(tryToWrite(path("other")));
  EXPECT_TRUE(tryToWrite(path()));
  EXPECT_EQ(content(path()), "new");
  EXPECT_EQ(files(), 2);
}

TEST_F(WrittenFile, DevicesAndPipesStayWhatTheyAre) {
  EXPECT_TRUE(writeFile("/dev/null", "x"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_TRUE(!fs::exists("/dev/full") || !writeFile("/dev/full", "x"));
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  EXPECT_TRUE(tryToWrite(path("pipe"))) << "and does not wait for a reader";
  EXPECT_TRUE(fs::is_fifo(path("pipe")));
}

/// Does something in a child process, and says how that ended.
int inChild(const std::function<int()>& work) {
  const ::pid_t child = ::fork();
  if (child == 0) ::_exit(work());
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

/// A disk that is full after so many bytes: a limit for the size of files, whose signal is ignored.
TEST_F(WrittenFile, AFullDiskLeavesTheOldFile) {
  constexpr ::rlim_t kSize = 200'000;
  const std::string old(1'000, 'o'), fresh(kSize, 'n');
  for (const ::rlim_t limit : {::rlim_t{0}, ::rlim_t{1}, ::rlim_t{999}, ::rlim_t{1'000}, ::rlim_t{4'096},
                               ::rlim_t{65'536}, kSize - 1, kSize, kSize + 1}) {
    ASSERT_TRUE(writeFile(path(), old));
    const int status = inChild([&] {
      std::signal(SIGXFSZ, SIG_IGN);
      const ::rlimit size{limit, limit};
      ::setrlimit(RLIMIT_FSIZE, &size);
      return writeFile(path(), fresh) ? 0 : 3;
    });
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), limit >= kSize ? 0 : 3) << limit;
    EXPECT_TRUE(content(path()) == (limit >= kSize ? fresh : old)) << limit;
    EXPECT_EQ(files(), 1) << limit;
  }
}

/// The writer is killed after some microseconds, at many points: also by the signal of a disk that is full.
TEST_F(WrittenFile, AKilledWriterLeavesTheOldFileOrTheNewOne) {
  const std::string old(1'000, 'o'), fresh(3'000'000, 'n');
  int olds = 0, news = 0;
  for (int k = 0; k < 120; ++k) {
    ASSERT_TRUE(writeFile(path(), old));
    const ::pid_t child = ::fork();
    if (child == 0) {
      static_cast<void>(writeFile(path(), fresh));
      ::pause();
    }
    ::usleep(static_cast<::useconds_t>(k * 100));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const std::string now = content(path());
    EXPECT_TRUE(now == old || now == fresh) << "after " << k * 100 << " µs: " << now.size() << " bytes";
    ++(now == old ? olds : news);
  }
  EXPECT_GT(olds, 0) << "none was killed in time";
  const int status = inChild([&] {
    const ::rlimit size{100'000, 100'000};
    ::setrlimit(RLIMIT_FSIZE, &size);
    return writeFile(path(), old + fresh) ? 0 : 3;
  });
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_NE(content(path()).size(), 100'000U);
}

}  // namespace
}  // namespace lgs::oracle
