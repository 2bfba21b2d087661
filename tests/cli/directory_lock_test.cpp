// Two runs with one --out: the second waits. What killed runs left is swept.

#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "program.hpp"
#include "refusal.hpp"

namespace polhode::test {
namespace directory_lock_test {

TEST(DirectoryLock, ASecondRunSaysThatItWaitsAndWaits) {
  const scratch_directory scratch;
  const std::string out = scratch.path("out");
  std::filesystem::create_directory(out);
  const int first = open(out.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  ASSERT_EQ(flock(first, LOCK_EX), 0);
  const pid_t second = start(polhode_command({"certify", "beta", "--out", out}),
                             scratch.path("printed"), scratch.path("errors"));
  while (contents(scratch.path("errors")).empty()) usleep(1000);
  EXPECT_TRUE(names_in(out).empty());
  int state = 0;
  EXPECT_EQ(waitpid(second, &state, WNOHANG), 0);
  close(first);
  waitpid(second, &state, 0);
  EXPECT_TRUE(WIFEXITED(state) && WEXITSTATUS(state) == 0);
  EXPECT_EQ(names_in(out), std::vector<std::string>{"beta.json"});
  EXPECT_EQ(contents(scratch.path("errors")),
            "polhode: another run writes into \"" + out + "\"; waiting until it ends\n");
}

/// The lock is the process's: one that is killed leaves none.
TEST(DirectoryLock, AKilledRunLeavesNoLock) {
  const scratch_directory scratch;
  const std::string out = scratch.path("out");
  run_command(polhode_command({"certify", "beta", "--out", out, "--digits", "20000"}), SIGKILL,
              50'000);
  certified({"certify", "beta", "--out", out});  // and says nothing of waiting
}

TEST(DirectoryLock, TwoRunsBothEnd) {
  const scratch_directory scratch;
  const outcome both = run_script(
      "polhode certify beta --out out >/dev/null & polhode certify beta --out out >/dev/null; "
      "status=$?; wait $! && exit $status",
      scratch.path(""));
  EXPECT_EQ(both.status, 0) << both.err;
  EXPECT_EQ(names_in(scratch.path("out")), std::vector<std::string>{"beta.json"});
}

TEST(TemporaryFiles, OfKilledRunsAreSwept) {
  const scratch_directory scratch;
  const std::string out = scratch.path("out");
  std::filesystem::create_directory(out);
  const std::string nobody = "999999999";  // beyond the greatest number of a process
  const std::string alive = std::to_string(getpid());
  std::vector<std::string> stay{".beta.json." + alive + ".0.tmp", ".notes.tmp", "x.json.1.0.tmp",
                                ".beta.json." + nobody + ".tmpx", "beta.json"};
  for (const std::string& name : stay) std::ofstream(out + '/' + name) << "mine";
  for (const char* name : {".beta.json.", ".gamma.json."}) {
    std::ofstream(out + '/' + name + nobody + ".0.tmp") << "half";
  }
  certified({"certify", "beta", "--out", out});
  std::vector<std::string> names = names_in(out);
  std::sort(names.begin(), names.end());
  std::sort(stay.begin(), stay.end());
  EXPECT_EQ(names, stay);
  // --certificate sweeps what is left of its own file alone.
  std::ofstream(out + "/.c.json." + nobody + ".0.tmp") << "half";
  std::ofstream(out + "/.d.json." + nobody + ".0.tmp") << "half";
  certified({"integrate", "x", "0", "1", "--certificate", out + "/c.json"});
  EXPECT_FALSE(std::filesystem::exists(out + "/.c.json." + nobody + ".0.tmp"));
  EXPECT_TRUE(std::filesystem::exists(out + "/.d.json." + nobody + ".0.tmp"));
}

}  // namespace directory_lock_test
}  // namespace polhode::test
