// polhode map and merge.

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "program.hpp"

namespace polhode::test {
namespace map_test {

using words = std::vector<std::string>;

words map_of(const words& more) {
  words command{"map",          "epsilon0", "--a",      "0.5..20/59", "--b",
                "0.05..0.9/59", "--log",    "--digits", "12"};
  command.insert(command.end(), more.begin(), more.end());
  return command;
}
std::string printed(const words& command) {
  const outcome result = run(command);
  EXPECT_EQ(result.status, 0) << result.err;
  return result.out;
}

TEST(Map, HasTheNumbersOfTheTable) {
  const outcome map = run({"map", "epsilon0", "--a", "12.65", "--b", "0.0629", "--digits", "20"});
  EXPECT_EQ(map.status, 0) << map.err;
  EXPECT_EQ(map.out,
            "a,a_exact,b,b_exact,epsilon0,epsilon0_radius\n"
            "12.65,253/20,0.0629,629/10000,0.11359438234143338362,9.6e-21\n")
      << run({"table", "epsilon0", "--ab", "12.65,0.0629", "--digits", "20"}).out;
}

TEST(Map, SaysWhatDoesNotExist) {
  const outcome map =
      run({"map", "c0", "meetings", "physical", "--a", "0.001..9/2", "--b", "0.001..0.9/2"});
  EXPECT_EQ(map.status, 0) << map.err;
  EXPECT_EQ(map.out.find("undecided"), std::string::npos);
  EXPECT_NE(map.out.find(",none,,"), std::string::npos) << map.out;
  EXPECT_EQ(run({"map", "phase", "--a", "1", "--b", "0.5", "--c", "-1..1/2"}).out,
            "a,a_exact,b,b_exact,c,c_exact,phase,phase_radius\n"
            "1,1,0.5,1/2,-1,-1,none,\n1,1,0.5,1/2,0,0,inf,0\n1,1,0.5,1/2,1,1,none,\n");
}

TEST(Map, IsTheSameWhateverTheShardsAndThreads) {
  const scratch_directory scratch;
  const std::string whole = printed(map_of({}));
  EXPECT_EQ(printed(map_of({"--threads", "1"})), whole);
  const std::string blocks = scratch.path("blocks");
  for (const char* shard : {"3/3", "1/3", "2/3"}) {
    EXPECT_EQ(run({"merge", blocks}).status, 2) << shard;
    (void)printed(map_of({"--blocks", blocks, "--shard", shard}));
  }
  EXPECT_EQ(printed({"merge", blocks}), whole);
  EXPECT_EQ(printed(map_of({"--blocks", blocks})), whole);
}

TEST(Map, ComputesADamagedBlockAgain) {
  const scratch_directory scratch;
  const std::string blocks = scratch.path("blocks");
  const std::string whole = printed(map_of({"--blocks", blocks}));
  const std::filesystem::path block = std::filesystem::path(blocks) / "block-000001.csv";
  ASSERT_TRUE(std::filesystem::exists(block));
  for (const bool cut : {true, false}) {
    if (cut) {
      std::filesystem::resize_file(block, std::filesystem::file_size(block) / 2);
    } else {
      std::filesystem::copy_file(std::filesystem::path(blocks) / "block-000000.csv", block,
                                 std::filesystem::copy_options::overwrite_existing);
    }
    const outcome merged = run({"merge", blocks});
    EXPECT_EQ(merged.status, 2);
    EXPECT_NE(merged.err.find("1 of 4 blocks are missing or not whole, the first is block 1"),
              std::string::npos)
        << merged.err;
    EXPECT_EQ(printed(map_of({"--blocks", blocks})), whole);
  }
}

TEST(Map, GoesOnAfterItWasKilled) {
  const scratch_directory scratch;
  const std::string blocks = scratch.path("blocks");
  const words command{"map",          "epsilon0", "--a", "0.5..20/99", "--b",
                      "0.05..0.9/99", "--digits", "60",  "--blocks",   blocks};
  for (int k = 0; k < 5; ++k) {
    std::string script = "timeout -s KILL 0.3 polhode";
    for (const std::string& word : command) script += " '" + word + "'";
    const outcome killed = run_script(script);
    EXPECT_TRUE(killed.out.empty() || killed.status == 0);
  }
  const std::string whole = printed(command);
  EXPECT_EQ(printed({"merge", blocks}), whole);
  words alone = command;
  alone.resize(alone.size() - 2);
  EXPECT_EQ(printed(alone), whole);
}

TEST(Map, RefusesWhatItCannotDo) {
  const auto refused = [](const words& command, const std::string& said) {
    const outcome result = run(command);
    EXPECT_EQ(result.status, 2) << result.out;
    EXPECT_NE(result.err.find(said), std::string::npos) << result.err;
  };
  refused({"map", "--a", "1", "--b", "0.5"}, "there is no quantity");
  refused({"map", "epsilonO", "--a", "1", "--b", "0.5"}, "there is no quantity");
  refused({"map", "phase", "--a", "1", "--b", "0.5"}, "give --c");
  refused({"map", "c0", "--a", "1", "--b", "0.5", "--c", "0.1"}, "of no motion");
  refused({"map", "c0", "--a", "0..1/4", "--b", "0.5"}, "a must be above 0");
  refused({"map", "c0", "--a", "1", "--b", "0.5..1/4"}, "b must be between 0 and 1");
  refused({"map", "c0", "--a", "1..2", "--b", "0.5"}, "the number of steps is missing");
  refused({"map", "c0", "--a", "2..1/3", "--b", "0.5"}, "--a");
  refused({"map", "c0", "--a", "1..2/99999", "--b", "0.1..0.2/99999"}, "at most");
  refused({"map", "c0", "--a", "1", "--b", "0.5", "--shard", "1/2"}, "--blocks");
  const scratch_directory scratch;
  const std::string blocks = scratch.path("blocks");
  refused({"merge", blocks}, "has no map.json");
  for (const char* shard : {"0/2", "3/2", "1", "1/2/3", "a/b", "-1/2", "1/99999999999"}) {
    refused({"map", "c0", "--a", "1", "--b", "0.5", "--blocks", blocks, "--shard", shard},
            "--shard");
  }
  (void)printed({"map", "c0", "--a", "1", "--b", "0.5", "--blocks", blocks});
  refused({"map", "c0", "--a", "1", "--b", "0.25", "--blocks", blocks}, "blocks of another map");
  std::ofstream(blocks + "/map.json") << "{}";
  refused({"merge", blocks}, "is not as this version of polhode writes it");
}

TEST(Map, IsDrawnWithItsCurves) {
  const words plane{"--a", "0.1..9/10", "--b", "0.02..0.9/10"};
  const auto drawn = [&](const words& before, const words& after) {
    words command = before;
    command.insert(command.end(), plane.begin(), plane.end());
    command.insert(command.end(), after.begin(), after.end());
    return run(command);
  };
  const outcome svg = drawn({"map", "epsilon0"}, {"--log", "--format", "svg"});
  if (svg.status == 1 && svg.err.find("gnuplot") != std::string::npos) GTEST_SKIP() << svg.err;
  EXPECT_EQ(svg.status, 0) << svg.err;
  for (const char* word :
       {"<svg", "epsilon0 over the plane of bodies", "I = 1<", "I = 2/3<", "J = 1<", "J = 2<"}) {
    EXPECT_NE(svg.out.find(word), std::string::npos) << word;
  }
  EXPECT_EQ(drawn({"map", "physical"}, {"--format", "png"}).out.rfind("\x89PNG", 0), 0U);
  for (const words& quantities :
       {words{"map", "epsilon0", "c0"}, {"map", "phase", "--c", "0.01"}}) {
    const outcome refused = drawn(quantities, {"--format", "svg"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("of one quantity"), std::string::npos) << refused.err;
  }
}

TEST(Map, AsNumPyHasIt) {
  const std::string file = printed(
      {"map", "meetings", "physical", "--a", "1..9/3", "--b", "0.1..0.5/1", "--format", "npy"});
  ASSERT_EQ(file.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  EXPECT_NE(file.find("'shape': (2, 2, 4, 2), "), std::string::npos);
  const std::size_t head = 10 + static_cast<unsigned char>(file[8]);
  EXPECT_EQ(head % 64, 0U);
  EXPECT_EQ(file.size(), head + 2 * 2 * 4 * 2 * sizeof(double));
}

}  // namespace map_test
}  // namespace polhode::test
