// polhode map and merge.

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/text.hpp"
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
  EXPECT_EQ(printed(map_of({"--block-size", "7"})), whole);
  const std::string small = scratch.path("small");
  EXPECT_EQ(printed(map_of({"--block-size", "700", "--blocks", small})), whole);
  EXPECT_EQ(printed({"merge", small}), whole);
  EXPECT_EQ(run(map_of({"--blocks", small})).status, 2);  // blocks of another size
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
  const std::string whole = printed(map_of({"--blocks", blocks, "--block-size", "1000"}));
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
    EXPECT_EQ(printed(map_of({"--blocks", blocks, "--block-size", "1000"})), whole);
  }
}

TEST(Map, GoesOnAfterItWasKilled) {
  const scratch_directory scratch;
  const std::string blocks = scratch.path("blocks");
  const words command{"map",          "epsilon0", "--a", "0.5..20/99", "--b",
                      "0.05..0.9/99", "--digits", "60",  "--blocks",   blocks};
  std::vector<std::string> outputs;
  for (int k = 0; k < 5; ++k) {
    std::string script = "timeout -s KILL 0.3 polhode";
    for (const std::string& word : command) script += " '" + word + "'";
    outputs.push_back(run_script(script).out);
  }
  const std::string whole = printed(command);
  // A run may be killed while it prints the map, too.
  for (const std::string& output : outputs) EXPECT_TRUE(whole.starts_with(output));
  EXPECT_EQ(printed({"merge", blocks}), whole);
  words alone = command;
  alone.resize(alone.size() - 2);
  EXPECT_EQ(printed(alone), whole);
}

TEST(Map, GoesOnWhenTheDiskHasRoomAgain) {
  const scratch_directory scratch;
  const std::string blocks = scratch.path("blocks");
  std::string script = "polhode";
  for (const std::string& word : map_of({"--blocks", blocks, "--block-size", "1000"}))
    script += " '" + word + "'";
  // Files may not grow beyond 50 KB here: no block of this map has so little.
  const outcome full = run_script("ulimit -f 100; " + script);
  EXPECT_EQ(full.status, 2);
  EXPECT_EQ(full.out, "");
  EXPECT_EQ(lines_of(full.err).size(), 1U) << full.err;
  EXPECT_NE(full.err.find("cannot be written"), std::string::npos) << full.err;
  EXPECT_EQ(names_in(blocks), std::vector<std::string>{"map.json"});
  EXPECT_EQ(printed(map_of({"--blocks", blocks, "--block-size", "1000"})), printed(map_of({})));
}

TEST(Map, SharesADirectoryWithAnotherRun) {
  const scratch_directory scratch;
  std::string script = "polhode";
  for (const std::string& word : map_of({"--blocks", scratch.path("blocks")})) {
    script += " '" + word + "'";
  }
  const outcome both = run_script(script + " > one & " + script + " > two; wait", scratch.path(""));
  EXPECT_EQ(both.err, "");
  const std::string whole = printed(map_of({}));
  EXPECT_EQ(contents(scratch.path("one")), whole);
  EXPECT_EQ(contents(scratch.path("two")), whole);
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
  refused({"map", "c0", "--a", "1"}, "the axes: give --a and --b");
  refused({"map", "c0", "--a", "1", "--b", "0.5", "--moments", "3,1..2/2,2..3/2"}, "the axes");
  refused({"map", "epsilon", "--chi", "1"}, "the axes");
  refused({"map", "c0", "--moments", "1,2,3"}, "fewer ranges than two");
  refused({"map", "c0", "--moments", "1..2/2,2..3/2,3..4/2"}, "three ranges");
  refused({"map", "c0", "--moments", "1..2/2,2..3/2"}, "2 in place of three moments");
  refused({"map", "c0", "--moments", "0..1/2,2..3/2,1"}, "moments are above 0");
  refused({"map", "c0", "--chi", "1", "--beta", "1"}, "there is epsilon alone");
  refused({"map", "epsilon", "--chi", "0..1/2", "--beta", "1"}, "chi must be above 0");
  refused({"map", "epsilon", "--chi", "1", "--beta", "-1..1/2"}, "beta must be above -1");
  const scratch_directory scratch;
  const std::string blocks = scratch.path("blocks");
  refused({"merge", blocks}, "has no map.json");
  for (const char* shard : {"0/2", "3/2", "1", "1/2/3", "a/b", "-1/2", "1/99999999999"}) {
    refused({"map", "c0", "--a", "1", "--b", "0.5", "--blocks", blocks, "--shard", shard},
            "--shard");
  }
  (void)printed({"map", "c0", "--a", "1", "--b", "0.5", "--blocks", blocks});
  refused({"map", "c0", "--a", "1", "--b", "0.25", "--blocks", blocks}, "blocks of another map");
  for (const char* size : {"0", "-1", "18446744073709551615"}) {
    std::string head = contents(blocks + "/map.json");
    const std::size_t at = head.find("\"points_of_block\": ") + 19;
    head.replace(at, head.find_first_not_of("0123456789-", at) - at, size);
    std::ofstream(blocks + "/map.json") << head;
    refused({"merge", blocks}, "is not as this version of polhode writes it");
  }
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
  if (svg.err.find("does not start") != std::string::npos) GTEST_SKIP() << svg.err;
  EXPECT_EQ(svg.status, 0) << svg.err;
  for (const char* word :
       {"<svg", "epsilon0 over the plane of bodies", "I = 1<", "I = 2/3<", "J = 1<", "J = 2<"}) {
    EXPECT_NE(svg.out.find(word), std::string::npos) << word;
  }
  EXPECT_EQ(drawn({"map", "physical"}, {"--format", "png"}).out.rfind("\x89PNG", 0), 0U);
  const outcome of_moments =
      run({"map", "epsilon0", "--moments", "3,1..2.9/5,0.5..2.5/5", "--format", "svg"});
  for (const char* word : {"epsilon0 over two moments, the third is 3", "moment 2", "planar<"}) {
    EXPECT_NE(of_moments.out.find(word), std::string::npos) << word;
  }
  const outcome of_limit =
      run({"map", "epsilon", "--chi", "1..2/5", "--beta", "-0.5..0.5/5", "--format", "svg"});
  EXPECT_NE(of_limit.out.find("epsilon in the limit of slender bodies"), std::string::npos);
  for (const words& quantities :
       {words{"map", "epsilon0", "c0"}, {"map", "phase", "--c", "0.01"}}) {
    const outcome refused = drawn(quantities, {"--format", "svg"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("of one quantity"), std::string::npos) << refused.err;
  }
}

TEST(Map, OverMoments) {
  // In whatever order the moments are given, the numbers are those of a and b.
  const std::string of_ratios = printed({"map", "epsilon0", "--a", "1", "--b", "1/3"});
  const std::string number = of_ratios.substr(of_ratios.find("1/3,") + 4);
  for (const words& moments : {words{"3,2..5/2,1..4/2", "2,2,1,1,"},
                               {"2..5/2,1..4/2,3", "2,2,1,1,"},
                               {"1..4/2,3,2..5/2", "1,1,2,2,"},
                               {"30,20..40/2,10..40/2", "20,20,10,10,"}}) {
    const outcome map = run({"map", "epsilon0", "--moments", moments[0]});
    EXPECT_EQ(map.status, 0) << map.err;
    EXPECT_NE(map.out.find('\n' + moments[1] + number), std::string::npos) << map.out;
  }
  // Two equal moments have no intermediate axis between them.
  EXPECT_EQ(printed({"map", "physical", "--moments", "1..2/1,2..3/1,3"}),
            "moment_1,moment_1_exact,moment_2,moment_2_exact,physical,physical_radius\n"
            "1,1,2,2,1,0\n1,1,3,3,none,\n2,2,2,2,none,\n2,2,3,3,none,\n");
  const scratch_directory scratch;
  const words map{"map", "c0", "meetings", "--moments", "3,1..2/7,1/2..5/2/5"};
  const std::string whole = printed(map);
  words in_blocks = map;
  const std::string blocks = scratch.path("blocks");
  in_blocks.insert(in_blocks.end(), {"--blocks", blocks, "--block-size", "5"});
  EXPECT_EQ(printed(in_blocks), whole);
  EXPECT_EQ(printed({"merge", blocks}), whole);
}

TEST(Map, OfTheLimit) {
  const std::string limit =
      printed({"map", "epsilon", "--chi", "1", "--beta", "1/2", "--digits", "20"});
  EXPECT_EQ(limit.rfind("chi,chi_exact,beta,beta_exact,epsilon,epsilon_radius\n1,1,0.5,1/2,", 0),
            0U);
  // A body near the limit: a = 10^12, chi = a b, beta = c/b.
  const auto epsilon_of = [](const words& command) {
    const std::string out = printed(command);
    std::istringstream row(out.substr(out.find('\n') + 1));
    std::vector<std::string> columns;
    for (std::string one; std::getline(row, one, ',');) columns.push_back(one);
    return std::stod(columns.at(columns.size() - 2));
  };
  EXPECT_NEAR(epsilon_of({"map", "epsilon", "--chi", "1", "--beta", "1/2"}),
              epsilon_of({"map", "epsilon", "--a", "1e12", "--b", "1e-12", "--c", "5e-13"}), 1e-9);
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

// ---------------------------------------------------------------------------------------------
// Cells

std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream row(line + ',');
    rows.emplace_back();
    for (std::string one; std::getline(row, one, ',');) rows.back().push_back(one);
  }
  rows.erase(rows.begin());
  return rows;
}

TEST(MapOfCells, CoversTheMapAndHoldsTheNumbersOfItsPoints) {
  const words quantities{"epsilon0", "c0", "intersections", "physical", "meetings"};
  words command{"map"};
  command.insert(command.end(), quantities.begin(), quantities.end());
  words cells = command;
  for (const char* one : {"--a", "0.05..20/3", "--b", "0.05..0.9/3", "--log", "--cells", "--refine",
                          "4", "--digits", "12"}) {
    cells.emplace_back(one);
  }
  const outcome map = run(cells);
  EXPECT_EQ(map.status, 1);  // c0 exists for some bodies of a cell only
  rational area = 0;
  long compared = 0;
  for (const std::vector<std::string>& row : rows_of(map.out)) {
    const auto number = [&](std::size_t k) { return parse_rational(row.at(k)); };
    const rational a_low = number(1);
    const rational a_high = number(3);
    const rational b_low = number(5);
    const rational b_high = number(7);
    area += (a_high - a_low) * (b_high - b_low);
    if (++compared % 7 != 0) continue;
    // A corner, and a point inside.
    for (const rational& part : {rational(0), rational(1, 3), rational(1)}) {
      words point = command;
      for (const std::string& one :
           {std::string("--a"), to_text(a_low + part * (a_high - a_low)), std::string("--b"),
            to_text(b_low + part * (b_high - b_low)), std::string("--digits"), std::string("12")}) {
        point.push_back(one);
      }
      const std::vector<std::string> numbers = rows_of(run(point).out).at(0);
      for (std::size_t k = 0; k < quantities.size(); ++k) {
        const std::string& value = numbers.at(4 + 2 * k);
        const std::string& low = row.at(8 + 2 * k);
        if (low == "undecided") continue;
        EXPECT_EQ(low == "none", value == "none") << quantities[k];
        if (low == "none") continue;
        const rational radius = parse_rational(numbers.at(5 + 2 * k));
        EXPECT_LE(parse_rational(low), parse_rational(value) + radius) << quantities[k];
        EXPECT_GE(number(9 + 2 * k), parse_rational(value) - radius) << quantities[k];
      }
    }
  }
  EXPECT_EQ(area, (20 - rational(1, 20)) * (rational(9, 10) - rational(1, 20)));
  EXPECT_GT(compared, 50);
}

TEST(MapOfCells, OverMomentsHoldTheNumbersOfTheirPoints) {
  const words command{"map", "epsilon0", "intersections", "physical", "--digits", "12"};
  words cells = command;
  cells.insert(cells.end(), {"--moments", "1/2..5/2/4,3,1..7/2/5", "--cells", "--refine", "5",
                             "--width", "0.2"});
  long known = 0;
  long compared = 0;
  for (const std::vector<std::string>& row : rows_of(run(cells).out)) {
    if (row.at(8) == "undecided" || ++known % 6 != 0) continue;
    // Corners, and a point inside: each with the moments in another order.
    for (const rational& part : {rational(0), rational(1, 3), rational(1)}) {
      const auto at = [&](std::size_t k) {
        const rational low = parse_rational(row.at(k));
        return rational(low + part * (parse_rational(row.at(k + 2)) - low));
      };
      const rational x = at(1);
      const rational y = at(5);
      words point = command;
      point.insert(point.end(), {"--moments", fmt::format("{0}..{1}/1,{2}..{3}/1,3", to_text(x),
                                                          to_text(rational(x + 1)), to_text(y),
                                                          to_text(rational(y + 1)))});
      const std::vector<std::string> numbers = rows_of(run(point).out).at(0);
      ++compared;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::string& value = numbers.at(4 + 2 * k);
        if (row.at(8 + 2 * k) == "undecided") continue;
        ASSERT_NE(value, "none") << to_text(x) << ' ' << to_text(y);
        const rational radius = parse_rational(numbers.at(5 + 2 * k));
        EXPECT_LE(parse_rational(row.at(8 + 2 * k)), parse_rational(value) + radius);
        EXPECT_GE(parse_rational(row.at(9 + 2 * k)), parse_rational(value) - radius);
      }
    }
  }
  EXPECT_GT(compared, 20);
}

TEST(MapOfCells, HasAreas) {
  EXPECT_EQ(printed({"map", "physical", "epsilon0", "--a", "1..2/1", "--b", "0.2..0.3/2", "--cells",
                     "--format", "areas"}),
            "quantity,value,percent_of_area\nphysical,1,50.00\nphysical,undecided,50.00\n");
  EXPECT_EQ(run(map_of({"--format", "areas"})).status, 2);
  EXPECT_EQ(run(map_of({"--cells", "--format", "areas"})).status, 2);  // no integer
}

TEST(MapOfCells, EndsAtTheWidthThatWasAskedFor) {
  const outcome map = run({"map", "epsilon0", "--a", "1..2/1", "--b", "0.1..0.2/1", "--cells",
                           "--refine", "12", "--width", "5e-2", "--digits", "10"});
  EXPECT_EQ(map.status, 0);
  for (const std::vector<std::string>& row : rows_of(map.out)) {
    EXPECT_LE(parse_rational(row.at(9)) - parse_rational(row.at(8)), rational(5, 100));
  }
}

TEST(MapOfCells, OfMotionsSaysWhatIsUndecided) {
  const outcome map = run({"map", "phase", "epsilon", "--a", "1..2/1", "--b", "0.3..0.4/1", "--c",
                           "-0.6..0.2/4", "--cells", "--digits", "5"});
  EXPECT_EQ(map.status, 1);
  const auto rows = rows_of(map.out);
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0].at(12), "none");       // c < -b
  EXPECT_EQ(rows[2].at(12), "undecided");  // up to the separatrix
  EXPECT_EQ(rows[3].at(14), "-1.919");
}

TEST(MapOfCells, IsTheSameWhateverTheShards) {
  const scratch_directory scratch;
  const words more{"--cells", "--refine", "3", "--width", "0.1"};
  const std::string whole = printed(map_of(more));
  const std::string blocks = scratch.path("blocks");
  for (const char* shard : {"2/2", "1/2"}) {
    words command = map_of(more);
    for (const std::string& one :
         {std::string("--blocks"), blocks, std::string("--shard"), std::string(shard)}) {
      command.push_back(one);
    }
    (void)printed(command);
  }
  EXPECT_EQ(printed({"merge", blocks}), whole);
  // A map of points is another one.
  EXPECT_EQ(run(map_of({"--blocks", blocks})).status, 2);
}

TEST(MapOfCells, AreDrawnWithTheUndecidedOnesInGrey) {
  const auto drawn = [](const words& quantity, const words& more) {
    words command{"map"};
    command.insert(command.end(), quantity.begin(), quantity.end());
    command.insert(command.end(), more.begin(), more.end());
    command.insert(command.end(), {"--log", "--cells", "--format", "svg"});
    return run(command);
  };
  const words plane{"--a", "0.1..9/6", "--b", "0.02..0.9/6", "--refine", "4"};
  const outcome svg = drawn({"intersections"}, plane);
  if (svg.err.find("does not start") != std::string::npos) GTEST_SKIP() << svg.err;
  EXPECT_EQ(svg.status, 0) << svg.err;
  EXPECT_NE(svg.out.find("I = 2/3<"), std::string::npos);
  words as_csv{"map", "intersections", "--log", "--cells"};
  as_csv.insert(as_csv.end(), plane.begin(), plane.end());
  int undecided = 0;
  int without = 0;  // cells on which the curves never meet
  for (const std::vector<std::string>& row : rows_of(printed(as_csv))) {
    if (row.at(8) != row.at(9)) ++undecided;
    if (row.at(8) == "0" && row.at(9) == "0") ++without;
  }
  const auto polygons = [&](const std::string& colour) {
    const std::string begin = "<polygon fill = '" + colour;
    int count = 0;
    for (std::size_t at = 0; (at = svg.out.find(begin, at)) != std::string::npos; ++at) ++count;
    return count;
  };
  EXPECT_GT(undecided, 0);
  EXPECT_EQ(polygons("rgb(184, 196, 208)"), undecided + 1);  // and one in the legend
  EXPECT_GT(without, 0);
  EXPECT_EQ(polygons("rgb(255, 247, 236)"), without + 1);  // and one in the scale of colours
  // Decided everywhere, and nowhere.
  const outcome decided = drawn({"physical"}, {"--a", "1..2/2", "--b", "0.1..0.2/2"});
  EXPECT_EQ(decided.status, 0) << decided.err;
  EXPECT_EQ(decided.out.find("rgb(184, 196, 208)"), std::string::npos);
  EXPECT_EQ(drawn({"intersections"}, {"--a", "1e3..1e6/2", "--b", "0.1..0.9/2"}).err, "");
  EXPECT_EQ(drawn({"c0"}, {"--a", "0.01..0.02/2", "--b", "0.1..0.2/2"}).err, "");
  // A range, where it exists for some bodies of a cell only.
  const outcome partly = drawn({"c0"}, plane);
  EXPECT_EQ(partly.status, 1) << partly.err;
  EXPECT_NE(partly.out.find("rgb(184, 196, 208)"), std::string::npos);
}

TEST(MapOfCells, RefusesWhatItDoesNotHave) {
  EXPECT_NE(run(map_of({"--refine", "3"})).err.find("give --cells, too"), std::string::npos);
  EXPECT_NE(run(map_of({"--cells", "--width", "0"})).err.find("a number above 0"),
            std::string::npos);
  EXPECT_EQ(run(map_of({"--cells", "--refine", "21"})).status, 2);
}

TEST(Map, HasACertificateOfItsCells) {
  const scratch_directory scratch;
  const std::string file = scratch.path() + "/map.json";
  for (const words& more :
       {words{"--a", "1..9/4", "--b", "0.1..0.9/4", "--refine", "5"},
        words{"--a", "1e-6..1e6/6", "--b", "1e-6..0.999999/6", "--log", "--refine", "3"},
        words{"--a", "1..2/1", "--b", "0.1..0.2/1"}}) {
    words command{"map", "intersections", "meetings", "physical", "--cells", "--certificate", file};
    command.insert(command.end(), more.begin(), more.end());
    const outcome map = run(command);
    EXPECT_EQ(map.status, 0) << map.err;
    EXPECT_NE(map.out.find("intersections_lower"), std::string::npos);
    const outcome check = run({"check", file});
    EXPECT_EQ(check.status, 0) << check.out << check.err;
    EXPECT_NE(check.out.find("map of intersections meetings physical"), std::string::npos);
  }
}

TEST(Map, RefusesACertificateOfWhatRationalsDoNotDecide) {
  const scratch_directory scratch;
  const std::string file = scratch.path() + "/map.json";
  const words plane{"--a", "1..2/2", "--b", "0.1..0.2/2", "--certificate", file};
  const auto refused = [&](words command, const words& more, const char* message) {
    command.insert(command.end(), more.begin(), more.end());
    const outcome o = run(command);
    EXPECT_EQ(o.status, 2);
    EXPECT_NE(o.err.find(message), std::string::npos) << o.err;
    EXPECT_FALSE(std::filesystem::exists(file));
  };
  refused({"map", "epsilon0", "--cells"}, plane, "epsilon0 is not among intersections, meetings");
  refused({"map", "physical"}, plane, "--cells is missing");
  refused({"map", "physical", "--cells", "--moments", "3,1..2/2,0.5..0.9/2", "--certificate", file},
          {}, "the axes are others");
  refused({"map", "physical", "--cells", "--a", "1", "--b", "0.1..0.2/2", "--certificate", file},
          {}, "a single number");
  refused({"map", "physical", "--cells", "--blocks", scratch.path() + "/blocks", "--shard", "1/2"},
          plane, "not of a shard");
}

}  // namespace map_test
}  // namespace polhode::test
