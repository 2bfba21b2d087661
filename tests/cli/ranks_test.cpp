// One run on several processes, under mpirun.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <ios>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "program.hpp"
#include "support/random.hpp"

#ifdef POLHODE_MPIEXEC

namespace polhode::test {
namespace ranks_test {
namespace {

using words = std::vector<std::string>;

/// Before a script. mpirun may start more processes than there are processors, also for root. The
/// address sanitizer does not look for leaks, as MPI has some.
const std::string mpirun = fmt::format(
    "export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
    "ASAN_OPTIONS=detect_leaks=0; exec '{}' --oversubscribe ",
    POLHODE_MPIEXEC);

const std::string map = " polhode map epsilon0 --a 0.5..20/59 --b 0.05..0.9/59 ";

std::string printed(const std::string& script) {
  const outcome result = run_script(script);
  EXPECT_EQ(result.status, 0) << script << '\n' << result.err;
  return result.out;
}

TEST(Ranks, PrintTheSameBytes) {
  const std::string whole = printed(map);
  EXPECT_EQ(lines_of(whole).size(), 3601U);
  for (const char* ranks : {"1", "2", "3", "5"}) {
    EXPECT_EQ(printed(mpirun + "-n " + ranks + map), whole) << ranks;
  }
  EXPECT_EQ(printed(mpirun + "-n 2" + map + "--threads 2"), whole);
  const scratch_directory scratch;
  const std::string blocks = " --blocks '" + scratch.path("blocks") + "'";
  (void)printed(mpirun + "-n 3" + map + blocks + " --shard 2/2");
  EXPECT_EQ(printed(mpirun + "-n 2" + map + blocks), whole);
  EXPECT_EQ(printed("polhode merge '" + scratch.path("blocks") + "'"), whole);
  EXPECT_EQ(printed(mpirun + "-n 3" + map + blocks), whole);  // nothing is left to do
  EXPECT_EQ(printed(mpirun + "-n 3 polhode map physical --a 1 --b 0.5"),
            printed("polhode map physical --a 1 --b 0.5"));  // fewer blocks than ranks
}

TEST(Ranks, GoOnWhenTheDiskHasRoomAgain) {
  const scratch_directory scratch;
  const std::string blocks = " --block-size 1000 --blocks '" + scratch.path("blocks") + "'";
  // Files may not grow beyond 50 KB here, as a block does; without the files in which ranks of one
  // machine share their memory.
  const outcome full = run_script(mpirun + "--mca btl self,tcp -n 3 sh -c \"ulimit -f 100; exec" +
                                  map + blocks + "\"");
  EXPECT_EQ(full.status, 2) << full.err;
  EXPECT_EQ(full.out, "");
  EXPECT_NE(full.err.find("cannot be written"), std::string::npos) << full.err;
  EXPECT_EQ(names_in(scratch.path("blocks")), std::vector<std::string>{"map.json"});
  EXPECT_EQ(printed(mpirun + "-n 3" + map + blocks), printed(map));
  EXPECT_NE(run_script(mpirun + "-n 2 sh -c \"exec" + map + " > /dev/full\"").status, 0);
}

TEST(Ranks, ProveTheSameClaims) {
  const std::string certify = " polhode certify count injectivity --ab 1..9/9,0.1..0.5/1 ";
  const scratch_directory scratch;
  const std::string whole = printed(certify + "--out '" + scratch.path("alone") + "'");
  for (const char* ranks : {"2", "5"}) {
    const std::string own = scratch.path(std::string("ranks_") + ranks);
    EXPECT_EQ(printed(mpirun + "-n " + ranks + certify + "--out '" + own + "'"), whole) << ranks;
    const std::vector<std::string> names = names_in(own);
    EXPECT_EQ(names.size(), 40U);
    for (const std::string& name : names) {
      EXPECT_EQ(contents(own + '/' + name), contents(scratch.path("alone/" + name))) << name;
    }
  }
  // Claims of one body, or of none, and theories are rank 0's alone.
  const std::string theory = scratch.path("body.v");
  (void)printed(mpirun + "-n 3 polhode certify --coq '" + theory + "' --digits 5");
  EXPECT_NE(contents(theory).find("Theorem"), std::string::npos);
  for (const std::string one : {" polhode certify beta ", " polhode certify count --ab 1,1/3 "}) {
    EXPECT_EQ(printed(mpirun + "-n 3" + one), printed(one));
  }
  EXPECT_NE(run_script(mpirun + "-n 2 polhode certify count --ab 0..1/9,0.1").status, 0);
}

TEST(Ranks, PrintTheSameTable) {
  for (const std::string format : {"csv", "json", "cpp"}) {
    const std::string table =
        " polhode table phase --ab 12.65,0.0629 --ab 18.27,0.0629 --c -0.06..0.06/120 --format " +
        format;
    EXPECT_EQ(printed(mpirun + "-n 3" + table), printed(table)) << format;
  }
}

/// Machines with fewer processors than a rank was told to use threads.
TEST(Ranks, NeedNotBeOnEqualMachines) {
  const std::string two = "-n 1 polhode ";
  const std::string one = " : -n 1 taskset -c \"$first\" polhode ";
  const std::string first = "first=$(taskset -cp $$ | sed 's/.*: //; s/[,-].*//'); ";
  for (const std::string command :
       {"table phase --ab 12.65,0.0629 --c -0.06..0.06/120 --threads 2",
        "map epsilon0 --a 0.5..20/59 --b 0.05..0.9/59 --threads 2 --block-size 70"}) {
    EXPECT_EQ(printed(first + mpirun + "--bind-to none " + two + command + one + command),
              printed("polhode " + command));
  }
}

TEST(Ranks, FailTogether) {
  const auto refused = [](const std::string& script, const std::string& said) {
    const outcome result = run_script(script);
    EXPECT_EQ(result.status, 2) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(said), std::string::npos) << result.err;
  };
  refused(mpirun + "-n 3 polhode map epsilonO --a 1 --b 0.5", "the nearest is epsilon");
  refused(mpirun + "-n 3 polhode map epsilon0 --a 1", "the axes: give --a and --b");
  // One of them is told another thing.
  const std::string three = "polhode map epsilon0 --a 1..2/99 --b 0.1..0.9/99";
  const std::string table = "polhode table epsilon0 --ab ";
  refused(mpirun + "-n 1 " + table + "1,0.5 : -n 1 " + table + "1,0.6",
          "rank 1: another command, or another version");
  refused(mpirun + "-n 1 " + three + " : -n 1 " + three + " --digits 16",
          "rank 1: another command, or another version");
  refused(mpirun + "-n 1 " + three + " : -n 1 " + three + " --digits 0", "rank 1: --digits");
  // By another launcher than that of this MPI, which leaves memory behind when it ends.
  refused("export ASAN_OPTIONS=detect_leaks=0; PMI_SIZE=2 polhode map epsilon0 --a 1 --b 0.5",
          "but MPI knows of one");
  refused("OMPI_COMM_WORLD_SIZE=2 '" POLHODE_WITHOUT_PAGES_PATH "' map epsilon0 --a 1 --b 0.5",
          "built without MPI");
}

TEST(Ranks, SayWhatIsNotCertified) {
  const std::string cells =
      " polhode map phase --a 1..2/50 --b 0.3..0.4/50 --c -0.6..0.2/4 --cells --digits 5";
  const outcome alone = run_script(cells);
  EXPECT_EQ(alone.status, 1);
  const outcome ranks = run_script(mpirun + "-n 3" + cells);
  EXPECT_EQ(ranks.status, 1);
  EXPECT_EQ(ranks.out, alone.out);
}

TEST(Ranks, ComputeTheSameScenes) {
  const scratch_directory scratch;
  const std::string file = scratch.path("sweep.toml");
  std::ofstream(file) << "digits = 20\n"
                         "[body]\nmoments = [3, 2, 1]\n"
                         "[state]\nomega = [0.1, 9, 0.2]\n"
                         "[time]\nto = 2\nsamples = 11\n"
                         "[effects]\nwant = [\"period\", \"montgomery_phase\", \"attitude\"]\n"
                         "[sweep]\n\"state.omega[0]\" = { from = 0.1, to = 1, steps = 6 }\n";
  const std::string scene = " polhode scene '" + file + "' --format ";
  for (const std::string format : {"text", "csv", "json"}) {
    EXPECT_EQ(printed(mpirun + "-n 3" + scene + format), printed(scene + format)) << format;
  }
  const auto all_in = [&](const std::string& directory) {
    std::string all;
    for (const std::string& name : names_in(directory)) {
      all += name + '\n' + contents(directory + '/' + name) + '\n';
    }
    return all;
  };
  const std::string alone = scratch.path("alone");
  const std::string together = scratch.path("together");
  (void)printed(scene + "text --out '" + alone + "'");
  const std::string more = scene + "text --out '" + together + "'";
  EXPECT_EQ(printed(mpirun + "-n 3" + more).substr(0, 2), "7 ");
  EXPECT_EQ(all_in(together), all_in(alone));
  // What an earlier run has computed is kept.
  std::filesystem::remove(together + "/sweep-0003.json");
  EXPECT_NE(printed(mpirun + "-n 2" + more).find("1 computed, 6 kept"), std::string::npos);
  EXPECT_EQ(all_in(together), all_in(alone));
}

TEST(Ranks, RunOtherCommandsAlone) {
  EXPECT_EQ(printed(mpirun + "-n 2 polhode eval 1+1"), "2 exactly\n2 exactly\n");
}

/// What the system says of a process; empty where it has ended.
std::string stat_of(const std::string& process) {
  try {
    return contents("/proc/" + process + "/stat");
  } catch (const std::ios_base::failure&) {  // it ended meanwhile
    return {};
  }
}

/// Processes of this program below another one.
std::vector<pid_t> programs_below(pid_t parent) {
  std::vector<pid_t> found;
  for (const std::string& name : names_in("/proc")) {
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    const std::string stat = stat_of(name);
    const std::size_t end = stat.rfind(')');
    if (end == std::string::npos || stat.find("(polhode)") == std::string::npos) continue;
    if (std::stol(stat.substr(end + 4)) == parent) found.push_back(std::stoi(name));
  }
  return found;
}

/// Not ended, nor ended and only not waited for.
bool is_running(pid_t process) {
  const std::string stat = stat_of(std::to_string(process));
  const std::size_t end = stat.rfind(')');
  return end != std::string::npos && stat.substr(end + 2, 1) != "Z";
}

/// Waits for a launcher, and returns its state. mpirun may wait for ever where a rank is killed
/// while the ranks start: without a rank that runs it is killed, too.
int state_of(pid_t launcher) {
  constexpr int most_looks = 1000;
  int state = 0;
  for (int idle = 0; waitpid(launcher, &state, WNOHANG) == 0; usleep(10'000)) {
    idle = std::ranges::any_of(programs_below(launcher), is_running) ? 0 : idle + 1;
    if (idle == most_looks) kill(launcher, SIGKILL);
  }
  return state;
}

/// The blocks that are there, by name, as files.
std::map<std::string, ino_t> blocks_in(const std::string& directory) {
  std::map<std::string, ino_t> result;
  if (!std::filesystem::exists(directory)) return result;
  for (const std::string& name : names_in(directory)) {
    struct stat file {};
    if (!name.starts_with("block-") || name.size() != std::string("block-000000.csv").size() ||
        stat((directory + '/' + name).c_str(), &file) != 0) {
      continue;
    }
    result[name] = file.st_ino;
  }
  return result;
}

TEST(Ranks, LoseNothingWhenOneIsKilled) {
  const std::string large = " polhode map epsilon0 --a 0.5..20/149 --b 0.05..0.9/149 --digits 60 ";
  const std::string whole = printed(large);
  std::mt19937_64 random(20);
  scratch_directory scratch;
  int directories = 0;
  const auto next_directory = [&] { return scratch.path(fmt::format("blocks{}", directories++)); };
  std::string blocks = next_directory();
  int killed = 0;
  for (support::repeat trial(30); trial.again();) {
    const std::map<std::string, ino_t> before = blocks_in(blocks);
    const scratch_directory output;
    const pid_t launcher =
        start({"/bin/sh", "-c",
               "PATH='" + std::filesystem::path(POLHODE_CLI_PATH).parent_path().string() +
                   "':\"$PATH\"; cd /; " + mpirun + "-n 3" + large + "--blocks '" + blocks + "'"},
              output.path("out"), output.path("err"));
    usleep(static_cast<useconds_t>(random() % 1'200'000));
    const std::vector<pid_t> ranks = programs_below(launcher);
    if (!ranks.empty()) {
      const std::size_t victim = random() % (ranks.size() + 1);
      kill(victim < ranks.size() ? ranks[victim] : launcher, SIGKILL);
      ++killed;
    }
    const int state = state_of(launcher);
    // Ranks whose launcher was killed end by themselves.
    for (const pid_t rank : ranks) {
      while (is_running(rank)) usleep(10'000);
    }
    const std::map<std::string, ino_t> after = blocks_in(blocks);
    for (const auto& [name, file] : before) {
      ASSERT_TRUE(after.contains(name));
      EXPECT_EQ(after.at(name), file) << name << " was computed twice";
    }
    if (WIFEXITED(state) && WEXITSTATUS(state) == 0) {
      EXPECT_EQ(contents(output.path("out")), whole);
      blocks = next_directory();
    }
  }
  EXPECT_EQ(printed(mpirun + "-n 3" + large + "--blocks '" + blocks + "'"), whole);
  EXPECT_EQ(printed("polhode merge '" + blocks + "'"), whole);
  RecordProperty("killed", killed);
}

}  // namespace
}  // namespace ranks_test
}  // namespace polhode::test

#endif
