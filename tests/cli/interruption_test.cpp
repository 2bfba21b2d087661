// What is left when the program is stopped in the middle: nothing, or whole files.

#include <csignal>
#include <string>

#include <gtest/gtest.h>

#include "polhode/certificate/certificate.hpp"
#include "program.hpp"

namespace polhode::test {
namespace interruption_test {

TEST(Interruption, EndsByTheSignalAndPrintsNothing) {
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP}) {
    const outcome result =
        run_command(polhode_command({"constants", "--digits", "5000000"}), signal_number, 200'000);
    EXPECT_EQ(result.signal, signal_number);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "");
  }
}

TEST(Interruption, LeavesWholeFilesOrNone) {
  const scratch_directory scratch;
  for (useconds_t delay = 500; delay < 30'000; delay += 700) {
    const std::string directory = scratch.path("out");
    const outcome result = run_command(
        polhode_command({"certify", "beta", "epsilon0_min", "--digits", "500", "--out", directory}),
        delay / 700 % 2 == 0 ? SIGINT : SIGTERM, delay);
    EXPECT_TRUE(result.status == 0 || result.signal != 0) << result.err;
    if (!std::filesystem::exists(directory)) continue;
    for (const std::string& name : names_in(directory)) {
      EXPECT_TRUE(name == "beta.json" || name == "epsilon0_min.json") << name;
      EXPECT_TRUE(json::accept(contents(scratch.path("out/" + name)))) << name;
    }
    std::filesystem::remove_all(directory);
  }
}

TEST(Interruption, AnIgnoredSignalStaysIgnored) {
  const outcome result = run_script(
      "trap '' HUP; polhode constants beta --digits 200000 > /dev/null & "
      "sleep 0.05; kill -HUP $!; wait $!");
  EXPECT_EQ(result.status, 0) << result.err;
}

TEST(Interruption, AReaderThatStopsReadingEndsItQuietly) {
  for (const char* before : {"", "trap '' PIPE; "}) {
    const outcome result =
        run_script(std::string(before) + "polhode constants --digits 100000 | head -c 10");
    EXPECT_EQ(result.out, "epsilon0_m");
    EXPECT_EQ(result.err, "");
  }
}

}  // namespace interruption_test
}  // namespace polhode::test
