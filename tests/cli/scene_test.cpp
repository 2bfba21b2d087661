// polhode scene: files in, certified files out, and nothing left behind by what is refused.

#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <set>

#include <gtest/gtest.h>

#include "enclosure.hpp"
#include "program.hpp"
#include "refusal.hpp"

namespace polhode::test {
namespace scene_test {

const std::string scenes = POLHODE_SCENES_DIR;

void write(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

const std::string racket =
    "digits = 20\n[body]\nmoments = [3, 2, 1]\n[state]\nomega = [0.1, 1, 0.3]\nunit = "
    "\"rad/s\"\n[time]\nto = 20\nsamples = 5\n"
    "[effects]\nwant = [\"period\", \"montgomery_phase\", \"momentum\"]\n";

TEST(SceneCommand, JsonHasEnclosuresAndWork) {
  const scratch_directory directory;
  write(directory.path("r.toml"), racket);
  const json report =
      json::parse(certified({"scene", directory.path("r.toml"), "--format", "json"}));
  const json& effects = report.at("effects");
  EXPECT_EQ(effects.size(), 4U);
  EXPECT_EQ(effects.at("regime").at("wanted"), false);
  expect_enclosure(effects.at("period").at("numbers").at("period"), 20);
  EXPECT_EQ(effects.at("period").at("numbers").at("period").at("unit"), "s");
  expect_enclosure(effects.at("montgomery_phase").at("numbers").at("phase"), 20);
  EXPECT_EQ(effects.at("period").at("work").at("integrals"), 1);
  EXPECT_EQ(effects.at("momentum").at("table").at("rows").size(), 5U);
  EXPECT_EQ(effects.at("momentum").at("table").at("rows")[1].at("t").at("rational"), "5");
}

TEST(SceneCommand, JsonHasTheUncertainties) {
  const scratch_directory directory;
  write(directory.path("u.toml"),
        "[body]\nmoments = [\"2 ± 0.25\", 3, \"1 +- 1/8\"]\n[effects]\nwant = [\"planarity\"]\n");
  const outcome result = run({"scene", directory.path("u.toml"), "--format", "json"});
  EXPECT_EQ(result.status, 1);  // undecided
  const json body = json::parse(result.out).at("body");
  EXPECT_EQ(body.at("moments").at("y").at("rational"), "2");
  EXPECT_EQ(body.at("sigma").at("x").at("rational"), "0");
  EXPECT_EQ(body.at("sigma").at("y").at("rational"), "1/4");
  EXPECT_EQ(body.at("sigma").at("z").at("rational"), "1/8");
  EXPECT_EQ(body.at("ranges").at("z").at("from").at("rational"), "7/8");
  EXPECT_EQ(body.at("ranges").at("z").at("to").at("rational"), "9/8");
  // Of rotational constants: the moment of 1/(4 ± 1) is from 1/5 to 1/3.
  write(directory.path("r.toml"),
        "[body]\nrotational = [2, \"4 ± 1\", 8]\n[effects]\nwant = [\"planarity\"]\n");
  const json molecule =
      json::parse(run({"scene", directory.path("r.toml"), "--format", "json"}).out).at("body");
  EXPECT_EQ(molecule.at("moments").at("y").at("rational"), "1/4");
  EXPECT_EQ(molecule.at("ranges").at("y").at("from").at("rational"), "1/5");
  EXPECT_EQ(molecule.at("ranges").at("y").at("to").at("rational"), "1/3");
}

TEST(SceneCommand, TextFitsATerminal) {
  for (const auto& entry : std::filesystem::directory_iterator(scenes)) {
    if (entry.path().extension() != ".toml") continue;
    const outcome result = run({"scene", entry.path().string()});
    EXPECT_LE(result.status, 1) << result.err;
    EXPECT_EQ(result.status == 1, entry.path().stem() == "tennis_racket") << entry.path();
    for (const std::string& line : lines_of(result.out)) {
      if (line.rfind(scenes, 0) == 0) continue;  // a path may be longer
      std::size_t columns = 0;
      for (const char c : line) columns += (static_cast<unsigned char>(c) & 0xc0U) != 0x80 ? 1 : 0;
      EXPECT_LE(columns, 100U) << line;
    }
  }
}

TEST(SceneCommand, WritesAllFilesAndKeepsThem) {
  const scratch_directory directory;
  const std::string out = directory.path("out");
  write(directory.path("r.toml"), racket);
  write(directory.path("s.toml"), racket + "[sweep]\n\"state.omega[1]\" = [1, 2, \"5/2\"]\n");
  const std::vector<std::string> command{"scene", directory.path("r.toml"),
                                         directory.path("s.toml"), "--out", out};
  EXPECT_NE(certified(command).find("4 scenes and points"), std::string::npos);
  const auto names = names_in(out);
  const std::set<std::string> files(names.begin(), names.end());
  for (const char* stem : {"r", "s-0001", "s-0002", "s-0003"}) {
    for (const char* end : {".json", ".txt", ".momentum.csv"})
      EXPECT_TRUE(files.contains(std::string(stem) + end)) << stem << end;
  }
  EXPECT_EQ(files.size(), 13U);
  const std::string table = contents(out + "/results.csv");
  EXPECT_NE(table.find(",2.5,5/2,period,period,s,"), std::string::npos) << table;
  // Again: nothing is done twice. A point that is gone, or is of another scene, is computed;
  // nothing else.
  EXPECT_NE(certified(command).find("0 computed, 4 kept"), std::string::npos);
  std::filesystem::remove(out + "/s-0002.json");
  write(out + "/s-0003.json", "{\"digest\": \"");
  EXPECT_NE(certified(command).find("2 computed, 2 kept"), std::string::npos);
  EXPECT_EQ(contents(out + "/results.csv"), table);
  write(directory.path("r.toml"), racket + "# another\n");
  EXPECT_NE(certified(command).find("1 computed, 3 kept"), std::string::npos);
}

TEST(SceneCommand, AnInterruptedSweepGoesOn) {
  const scratch_directory directory;
  const std::string out = directory.path("out");
  write(directory.path("s.toml"),
        "digits = 100\n[body]\nmoments = [3, 2, 1]\n[state]\nomega = [0.1, 1, "
        "0.3]\n[effects]\nwant = [\"twist_curve\"]\n"
        "[sweep]\n\"state.omega[1]\" = { from = 1, to = 2, steps = 19 }\n");
  const std::vector<std::string> command{"scene", directory.path("s.toml"), "--out", out};
  constexpr useconds_t some = 300'000;
  const outcome stopped = run_command(polhode_command(command), SIGINT, some);
  std::size_t whole = 0;
  if (std::filesystem::exists(out)) {
    for (const std::string& name : names_in(out)) {
      EXPECT_NE(name.front(), '.') << name;
      if (name.ends_with(".json")) {
        ++whole;
        EXPECT_TRUE(json::accept(contents(out + '/' + name)));
      }
    }
  }
  const std::string end = certified(command);
  if (stopped.signal == SIGINT) {
    EXPECT_NE(
        end.find(std::to_string(20 - whole) + " computed, " + std::to_string(whole) + " kept"),
        std::string::npos)
        << end;
  }
}

TEST(SceneCommand, TakesSettings) {
  const scratch_directory directory;
  write(directory.path("r.toml"), racket);
  const auto with = [&](const std::vector<std::string>& settings, bool has_file = true) {
    std::vector<std::string> arguments{"scene"};
    if (has_file) arguments.push_back(directory.path("r.toml"));
    for (const std::string& one : settings) {
      arguments.emplace_back("--set");
      arguments.push_back(one);
    }
    arguments.insert(arguments.end(), {"--format", "json"});
    return arguments;
  };
  const std::vector<std::string> whole{"body.moments = [3, 2, 1]", "state.omega=[0, 1, 0.1]",
                                       "effects.want=[\"period\"]", "digits=20"};
  write(directory.path("same.toml"),
        "digits = 20\n[body]\nmoments = [3, 2, 1]\n[state]\nomega = [0, 1, 0.1]\n[effects]\nwant = "
        "[\"period\"]\n");
  const auto effects_of = [](const outcome& result) {
    EXPECT_EQ(result.status, 0) << result.err;
    return json::parse(result.out).at("effects");
  };
  const json expected = effects_of(run({"scene", directory.path("same.toml"), "--format", "json"}));
  EXPECT_EQ(effects_of(run(with(whole, false))), expected);
  // The later one counts; a key can be taken away, and another be given.
  EXPECT_EQ(effects_of(run(with({whole[0], "state.omega=[9, 1, 3]", whole[1], whole[2], whole[3],
                                 "time =", "state.quaternion =", "body.unit =", "state.unit ="}))),
            expected);
  expect_refused(with({"x"}), {"--set \"x\"", "KEY=VALUE"});
  expect_refused(with({"body.moments=[3, 2"}), {"KEY=VALUE"});
  expect_refused(with({"body.moments=[3, 2, -1]"}), {"--set: body.moments"});
  expect_refused(with({"effects.want=[\"perid\"]"}), {"--set", "\"period\""});
  expect_refused(with({"a.b.c=1"}), {"--set"});
  expect_refused(with({"=1"}), {"KEY=VALUE"});
  expect_refused(with({"digits=20"}, false), {"no [body]"});
}

TEST(SceneCommand, RefusesBadInputAndLeavesNothing) {
  const scratch_directory directory;
  const std::string out = directory.path("out");
  const auto refused = [&](const std::string& text, const std::vector<std::string>& words) {
    write(directory.path("bad.toml"), text);
    write(directory.path("good.toml"), racket);
    expect_refused({"scene", directory.path("good.toml"), directory.path("bad.toml"), "--out", out},
                   words);
    EXPECT_FALSE(std::filesystem::exists(out));
  };
  const std::string body = "[body]\nmoments = [3, 2, 1]\n";
  refused(body + "[effects]\nwant = [\"fliips\"]\n", {"bad.toml", "line 4", "\"flips\""});
  refused(body + "[effects]\nwant = [\"period\"]\n", {"line 4", "needs a state"});
  refused(body + "[state]\nomega = [0, 0, 0]\n[effects]\nwant = [\"period\"]\n",
          {"line 4", "does not turn"});
  refused("[body]\nmoments = [inf, 2, 1]\n[effects]\nwant = [\"planarity\"]\n",
          {"line 2", "finite"});
  refused("", {"empty"});
  refused("\xff\xfe", {"line 1"});
  refused(std::string(1'000'000, '['), {"line 1"});
  refused(std::string(5'000'000, '#'), {"longer than 4000000 bytes"});
  // A point of the sweep that cannot be, although the file's own numbers can.
  refused(body +
              "[state]\nomega = [1, 0, 0]\n[effects]\nwant = "
              "[\"period\"]\n[sweep]\n\"state.omega[0]\" = [1, 0]\n",
          {"does not turn"});
  expect_refused({"scene"}, {"no scene"});
  expect_refused({"scene", directory.path("none.toml")}, {"No such file"});
  expect_refused({"scene", directory.path("")}, {"directory"});
  ASSERT_EQ(mkfifo(directory.path("pipe").c_str(), 0600), 0);
  expect_refused({"scene", directory.path("pipe")}, {"regular file"});
  expect_refused({"scene", directory.path("good.toml"), "--format", "xml"}, {"--format"});
  expect_refused({"scene", directory.path("good.toml"), directory.path("good.toml"), "--out", out},
                 {"same files"});
  EXPECT_FALSE(std::filesystem::exists(out));
}

constexpr bool have_pages = POLHODE_HAVE_PAGES != 0;
constexpr const char* without_pages = "built without pages";

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin) + begin.size();
  return text.substr(from, text.find(end, from) - from);
}

TEST(SceneCommand, PageNeedsNothingElse) {
  if (!have_pages) GTEST_SKIP() << without_pages;
  const scratch_directory directory;
  const std::string hostile = "</script><!-- <b onclick='x()'>%DATA%\u2028 & \\\" @x@";
  write(directory.path("r.toml"),
        "title = \"" + hostile + "\"\nsource = \"" + hostile + "\"\n" + racket);
  (void)certified({"scene", directory.path("r.toml"), "--out", directory.path("out"), "--page"});
  const std::string page = contents(directory.path("out/r.html"));
  // The policy forbids the page to load anything, and to run any script but its own.
  const std::string policy = between(page, "Content-Security-Policy\" content=\"", "\"");
  EXPECT_EQ(policy.rfind("default-src 'none'; script-src 'sha256-", 0), 0U) << policy;
  EXPECT_EQ(policy.find("unsafe"), std::string::npos) << policy;
  // Nothing of the title has come to stand outside of its text.
  std::size_t scripts = 0;
  for (std::size_t at = page.find("</script"); at != std::string::npos;
       at = page.find("</script", at + 1)) {
    ++scripts;
  }
  EXPECT_EQ(scripts, 2U);
  EXPECT_EQ(page.find("<!--"), std::string::npos);
  EXPECT_EQ(page.find("<b onclick"), std::string::npos);
  const json data = json::parse(between(page, "<script id=\"data\" type=\"application/json\">",  //
                                        "</script>"));
  EXPECT_EQ(data.at("title"), "</script><!-- <b onclick='x()'>%DATA%\u2028 & \" @x@");
  EXPECT_EQ(data.at("omega").size(), 5U);
  EXPECT_EQ(data.at("stride"), 1);
  // What the licence of three.js asks for.
  EXPECT_NE(page.find("three.js authors"), std::string::npos);
  EXPECT_NE(page.find("Permission is hereby granted"), std::string::npos);
  // A page is asked for again where it is gone.
  std::filesystem::remove(directory.path("out/r.html"));
  const std::string again =
      certified({"scene", directory.path("r.toml"), "--out", directory.path("out"), "--page"});
  EXPECT_NE(again.find("1 computed, 0 kept"), std::string::npos) << again;
  EXPECT_EQ(contents(directory.path("out/r.html")), page);
}

TEST(SceneCommand, PageHasTheSolidsAndNotTooManySamples) {
  if (!have_pages) GTEST_SKIP() << without_pages;
  const scratch_directory directory;
  write(directory.path("s.toml"),
        "precision = \"double\"\n[[body.solid]]\nshape = \"box\"\nsize = [2, 4, 6]\nmass = 1\n"
        "[[body.solid]]\nshape = \"cylinder\"\naxis = \"x\"\nradius = 1\nheight = 4\nmass = 1\n"
        "position = [0, 0, 4]\n[state]\nomega = [1, 0, 2]\nunit = \"rad/s\"\n"
        "[time]\nto = 5\nsamples = 50001\n[effects]\nwant = [\"attitude\"]\n");
  EXPECT_EQ(
      run({"scene", directory.path("s.toml"), "--out", directory.path("out"), "--page"}).status,
      1);  // in double nothing is certified
  const json data =
      json::parse(between(contents(directory.path("out/s.html")),
                          "<script id=\"data\" type=\"application/json\">", "</script>"));
  EXPECT_EQ(data.at("stride"), 3);
  EXPECT_EQ(data.at("t").size(), 16667U);
  EXPECT_EQ(data.at("q").size(), 16667U);
  const json& solids = data.at("solids");
  ASSERT_EQ(solids.size(), 2U);
  // The centre of mass is at z = 2: the box reaches from -5 to 1.
  EXPECT_EQ(solids[0].at("half"), json({0.2, 0.4, 0.6}));
  EXPECT_EQ(solids[0].at("position"), json({0.0, 0.0, -0.4}));
  EXPECT_EQ(solids[1].at("half"), json({0.4, 0.2, 0.2}));
  EXPECT_EQ(solids[1].at("position"), json({0.0, 0.0, 0.4}));
  EXPECT_EQ(solids[1].at("axis"), 0);
}

TEST(SceneCommand, WithoutPagesSaysSo) {
  const scratch_directory directory;
  write(directory.path("r.toml"), racket);
  std::vector<std::string> command{POLHODE_WITHOUT_PAGES_PATH, "scene", directory.path("r.toml"),
                                   "--out", directory.path("out")};
  EXPECT_EQ(run_command(command).status, 0);
  std::filesystem::remove_all(directory.path("out"));
  command.emplace_back("--page");
  const outcome refused = run_command(command);
  EXPECT_EQ(refused.status, 2);
  EXPECT_TRUE(refused.out.empty());
  for (const char* word : {"built without pages", "nodejs", "npm", "leave out --page"})
    EXPECT_NE(refused.err.find(word), std::string::npos) << refused.err;
  EXPECT_EQ(lines_of(refused.err).size(), 1U);
  EXPECT_FALSE(std::filesystem::exists(directory.path("out")));
}

// In a headless browser, where there is one: it draws, scrubs, plays, heeds the keys, and has no
// error.
TEST(SceneCommand, PageRunsInABrowser) {
  if (!have_pages) GTEST_SKIP() << without_pages;
  if (sanitized || run_script("command -v chromium >&2").status != 0) GTEST_SKIP() << "no chromium";
  const scratch_directory directory;
  // Solids with attitude, momentum and curves; the momentum alone, with a hostile title.
  write(directory.path("hostile.toml"),
        "title = \"</script><script>document.documentElement.dataset.hostile = 1</script>\"\n" +
            racket);
  write(directory.path("wide.toml"),
        "[body]\nmoments = [3, 2, \"1.5 ± 0.1\"]\n[state]\nomega = [1, 2, 3]\nunit = \"rad/s\"\n"
        "[time]\nto = 1\n[effects]\nwant = [\"inertial_defect\", \"audit\", \"attitude\"]\n");
  ASSERT_EQ(run({"scene", scenes + "/skateboard.toml", directory.path("hostile.toml"),
                 directory.path("wide.toml"), "--out", directory.path("out"), "--page"})
                .status,
            0);
  for (const std::string name : {"skateboard", "hostile", "wide"}) {
    const auto shown_by_browser = [&] {
      return run_script(
          "HOME=$PWD timeout 120 chromium --headless=new --no-sandbox --use-angle=swiftshader "
          "--enable-unsafe-swiftshader "
          "--window-size=800,600 --virtual-time-budget=20000 --dump-dom "
          "file://$PWD/out/" +
              name + ".html#check",
          directory.path(""));
    };
    // A browser that a busy machine starves may not come to draw at all, or only once: then it is
    // asked again.
    outcome shown = shown_by_browser();
    const std::string last = "data-played=\"yes\"";
    for (int again = 0; again < 2 && shown.out.find(last) == std::string::npos; ++again) {
      shown = shown_by_browser();
    }
    const std::string attributes = between(shown.out, "<html", ">");
    for (const char* word :
         {"data-errors=\"0\"", "data-drawn=\"yes\"", "data-scrubbed=\"yes\"", "data-keys=\"yes\"",
          "data-choices=\"yes\"", "data-played=\"yes\"", "data-gl=\"0\""}) {
      EXPECT_NE(attributes.find(word), std::string::npos)
          << name << ": " << word << " in " << attributes << shown.err;
    }
    EXPECT_EQ(attributes.find("hostile"), std::string::npos) << attributes;
    if (name == "wide") {  // what shares no digits, as the nearest decimal with its error
      for (const char* effect : {"inertial defect</h2>", "audit</h2>"}) {
        const std::string section = between(shown.out, effect, "</section>");
        EXPECT_NE(section.find(" ± "), std::string::npos) << section;
      }
      EXPECT_EQ(shown.out.find("class=\"value\">["), std::string::npos);
    }
    if (name != "skateboard") continue;
    // The axes of the curves: symbols with units, and round numbers.
    for (const char* label : {">Δφ [rad]</text>", ">ε [rad]</text>", ">-0.02</text>", ">10</text>"})
      EXPECT_NE(shown.out.find(label), std::string::npos) << label;
    for (const char* other : {"0.5477", ">phase</text>"})
      EXPECT_EQ(shown.out.find(other), std::string::npos) << other;
  }
}

TEST(SceneCommand, PlotsWhereGnuplotIs) {
  const scratch_directory directory;
  write(directory.path("r.toml"), racket);
  const outcome result =
      run({"scene", directory.path("r.toml"), "--out", directory.path("out"), "--plot", "svg"});
  if (result.status == 0) {
    const std::string picture = contents(directory.path("out/r.momentum.svg"));
    for (const char* part : {"</svg>", "ω", "[rad/s]", "J/|J|", "gpPt6", "gpPt4", "gpPt8"})
      EXPECT_NE(picture.find(part), std::string::npos) << part;
    EXPECT_EQ(picture.find("omega"), std::string::npos);
  } else {
    EXPECT_NE(result.err.find("gnuplot"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(directory.path("out")));
  }
  expect_refused({"scene", directory.path("r.toml"), "--plot", "svg"}, {"--out"});
  expect_refused({"scene", directory.path("r.toml"), "--out", directory.path("o"), "--plot", "gif"},
                 {"svg, png or pdf"});
}

TEST(SceneCommand, PlotsPdfWhereGnuplotCan) {
  const scratch_directory directory;
  write(directory.path("r.toml"), racket);
  const outcome result =
      run({"scene", directory.path("r.toml"), "--out", directory.path("out"), "--plot", "pdf"});
  if (result.status == 0) {
    EXPECT_EQ(contents(directory.path("out/r.momentum.pdf")).rfind("%PDF-", 0), 0U);
  } else {
    EXPECT_NE(result.err.find("gnuplot"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(directory.path("out")));
  }
  // A gnuplot without the terminal: what would be right is said.
  write(directory.path("gnuplot"),
        "#!/bin/sh\nif grep -q pdfcairo; then exit 1; else echo 1; fi\n");
  std::filesystem::permissions(directory.path("gnuplot"), std::filesystem::perms::owner_all);
  const outcome refused = run_script(
      "PATH=\"$PWD:$PATH\"; polhode scene r.toml --out none --plot pdf", directory.path(""));
  EXPECT_EQ(refused.status, 2);
  for (const char* word : {"pdfcairo", "install", "--plot svg"})
    EXPECT_NE(refused.err.find(word), std::string::npos) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(directory.path("none")));
}

TEST(SceneCommand, ListsTheEffects) {
  const std::string list = certified({"scene", "--list"});
  for (const char* name : {"planarity", "montgomery_phase", "attitude", "flips", "audit"})
    EXPECT_NE(list.find(name), std::string::npos);
  // The manual has the same ones.
  const std::string manual = contents(scenes + "/../docs/scenes.md");
  for (const std::string& line : lines_of(list)) {
    EXPECT_NE(manual.find("| `" + line.substr(0, line.find(' ')) + "` |"), std::string::npos)
        << line;
  }
}

}  // namespace scene_test
}  // namespace polhode::test
