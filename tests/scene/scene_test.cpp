// Reading scenes: exact numbers, every way to give a body, and what is refused.

#include "polhode/scene/scene.hpp"

#include <sys/stat.h>

#include <fstream>

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/scene/body_file.hpp"
#include "support/scratch_directory.hpp"

namespace polhode {
namespace scene_test {

scene read(const std::string& text) { return read_scene(text, "."); }

const std::string wanting = "[effects]\nwant = [\"planarity\"]\n";

std::string with_body(const std::string& body) { return "[body]\n" + body + "\n" + wanting; }

rational_vector moments_of(const std::string& body) {
  return *read(with_body(body)).body.axes->rational_moments();
}

std::string refusal(const std::string& text, const std::map<std::string, rational>& replaced = {}) {
  try {
    (void)read_scene(text, ".", replaced);
  } catch (const input_error& error) {
    return error.what();
  }
  return "accepted";
}

void expect_refused(const std::string& text, const std::vector<std::string>& words) {
  const std::string why = refusal(text);
  for (const std::string& word : words)
    EXPECT_NE(why.find(word), std::string::npos) << word << " in: " << why;
}

TEST(SceneNumbers, AreThoseThatAreWritten) {
  // Neither is a double. Before them stand characters of two, three and four bytes.
  const auto m = moments_of("name = \"é ∑ 𝒥\"\nmoments = [0.3, 2_0.1e-2, 1E-1]  # 0.7");
  EXPECT_EQ(m, (rational_vector{rational(3, 10), rational(201, 1000), rational(1, 10)}));
  EXPECT_EQ(moments_of("moments = [\"1/3\", 0x10, +0.25]"),
            (rational_vector{16, rational(1, 3), rational(1, 4)}));
  const auto inline_table =
      read("body = {name = \"é\", moments = [\n 3,\n 2.10, # é\n 1.7]}\n" + wanting);
  EXPECT_EQ(*inline_table.body.axes->rational_moments(),
            (rational_vector{3, rational(21, 10), rational(17, 10)}));
  // More digits than a double has.
  EXPECT_EQ(moments_of("moments = [3, 2.00000000000000000000000000001, 1]")[1],
            parse_rational("2.00000000000000000000000000001"));
  EXPECT_EQ(moments_of("moments = [3, 2, \"1e-1000\"]")[2], parse_rational("1e-1000"));
}

TEST(SceneNumbers, NotFinite) {
  expect_refused(with_body("moments = [inf, 2, 1]"), {"line 2", "finite"});
  expect_refused(with_body("moments = [3,\n 2,\n nan]"), {"line 4", "finite"});
  expect_refused(with_body("moments = [1e999, 2, 1]"), {"line 2"});
  expect_refused(with_body("moments = [\"nan\", 2, 1]"), {"line 2", "body.moments[0]", "nan"});
  expect_refused(with_body("moments = [1979-05-27, 2, 1]"), {"line 2", "dates"});
}

TEST(SceneBody, EveryWay) {
  EXPECT_EQ(*read(with_body("ab = [1, \"1/3\"]")).body.axes->rational_moments(),
            (rational_vector{rational(3, 2), 1, rational(1, 2)}));
  // (2, 3, 6) turned by the rotation with columns (2,1,2)/3, (-2,2,1)/3, (-1,-2,2)/3.
  const scene turned =
      read(with_body("tensor = [[\"26/9\", \"4/9\", \"-10/9\"], [\"4/9\", \"38/9\", \"-14/9\"], "
                     "[\"-10/9\", \"-14/9\", \"35/9\"]]"));
  EXPECT_EQ(*turned.body.axes->rational_moments(), (rational_vector{6, 3, 2}));
  // v_x is along (-1, -2, 2), or (1, 2, -2), of which the first component is positive.
  EXPECT_TRUE(overlaps(turned.body.axes->axis(0, 100)[2], ball(rational(-2, 3), 100)));
  const auto water = read(with_body("rotational = [9.28, 14.52, 27.88]\nunit = \"1/cm\""));
  EXPECT_EQ(water.body.kind, body_kind::non_physical);
  EXPECT_TRUE(water.body.has_unit);
  // I = h/(8 pi^2 c B): 3.016...e-47 kg m^2 for 9.28/cm.
  const ball greatest = water.body.size.at(128) * water.body.moments()[0];
  EXPECT_TRUE(certainly_less(greatest, ball(parse_rational("3.02e-47"), 64)));
  EXPECT_TRUE(certainly_less(ball(parse_rational("3.01e-47"), 64), greatest));
}

TEST(SceneBody, IrrationalMoments) {
  // Eigenvalues 4 and (3 +- sqrt 5)/2: the kind is decided all the same.
  const scene s = read(with_body("tensor = [[1, 1, 0], [1, 2, 0], [0, 0, 4]]"));
  EXPECT_FALSE(s.body.axes->rational_moments());
  EXPECT_TRUE(s.body.axes->rigid());
  EXPECT_EQ(s.body.kind, body_kind::non_physical);  // 4 > 3
  EXPECT_EQ(read(with_body("tensor = [[1, 1, 0], [1, 2, 0], [0, 0, 3]]")).body.kind,
            body_kind::planar);
  EXPECT_EQ(read(with_body("tensor = [[1, 1, 0], [1, 2, 0], [0, 0, 2.99]]")).body.kind,
            body_kind::physical);
}

TEST(SceneBody, Solids) {
  const auto solid = [](const std::string& s) { return "[[body.solid]]\n" + s + "\n"; };
  // A box of mass 12: a^2 + b^2 and so on.
  EXPECT_EQ(*read(solid("shape = \"box\"\nsize = [1, 2, 3]\nmass = 12") + wanting)
                 .body.axes->rational_moments(),
            (rational_vector{13, 10, 5}));
  // Split into two halves it is the same, wherever it lies.
  const scene halves =
      read(solid("shape = \"box\"\nsize = [1, 1, 3]\nmass = 6\nposition = [7, 0.5, 1]") +
           solid("shape = \"box\"\nsize = [1, 1, 3]\nmass = 6\nposition = [7, 1.5, 1]") + wanting);
  EXPECT_EQ(*halves.body.axes->rational_moments(), (rational_vector{13, 10, 5}));
  // By density: the same, and pi comes out of cylinders and ellipsoids.
  const scene dense = read(solid("shape = \"box\"\nsize = [1, 2, 3]\ndensity = 2") + wanting);
  EXPECT_EQ(*dense.body.axes->rational_moments(), (rational_vector{13, 10, 5}));
  const scene round =
      read(solid("shape = \"cylinder\"\naxis = \"x\"\nradius = 2\nheight = 6\ndensity = 1") +
           solid("shape = \"ellipsoid\"\nsemi_axes = [1, 1, 3]\ndensity = 10") + wanting);
  EXPECT_EQ(round.body.size.power, 1);
  // Cylinder: 24 pi, m r^2/2 = 48 pi along x, m (r^2/4 + h^2/12) = 96 pi across. Ellipsoid: 40 pi,
  // m (1+9)/5 = 80 pi, 16 pi about z.
  EXPECT_EQ(*round.body.axes->rational_moments(), (rational_vector{176, 128, 112}));
  expect_refused(solid("shape = \"box\"\nsize = [1, 2, 3]\ndensity = 1") +
                     solid("shape = \"cylinder\"\nradius = 1\nheight = 2\ndensity = 1") + wanting,
                 {"line 5", "pi", "masses"});
  expect_refused(solid("shape = \"box\"\nsize = [1, 0, 3]\nmass = 12") + wanting,
                 {"line 3", "0 must be positive"});
  expect_refused(solid("shape = \"box\"\nsize = [1, 2, 3]\nmass = -12") + wanting,
                 {"line 4", "-12 must be positive"});
  expect_refused(solid("shape = \"box\"\nsize = [1, 2, 3]") + wanting, {"neither"});
  expect_refused(solid("shape = \"box\"\nsize = [1, 2, 3]\nmass = 1\ndensity = 1") + wanting,
                 {"a mass and a density"});
  expect_refused(solid("shape = \"sphere\"\nradius = 1\nmass = 1") + wanting,
                 {"line 2", "sphere", "one of", "box"});
  expect_refused(solid("shape = \"box\"\nsize = [1, 2, 3]\nmass = 1\nradius = 1") + wanting,
                 {"line 5", "\"radius\""});
  expect_refused(
      solid("shape = \"cylinder\"\nradius = 1\nheight = 1\naxis = \"w\"\nmass = 1") + wanting,
      {"line 5", "axis"});
}

TEST(SceneBody, Imports) {
  const support::scratch_directory directory;
  const auto write = [&](const std::string& name, const std::string& text) {
    std::ofstream(directory.path(name)) << text;
  };
  const auto from = [&](const std::string& keys) {
    return read_scene("[body]\n" + keys + "\n" + wanting, directory.path(""));
  };
  write("a.urdf",
        "<robot><link name=\"base\"><inertial><mass value=\"1\"/><inertia ixx=\"0.3\" ixy=\"0\" "
        "ixz=\"0\" iyy=\"0.2\" iyz=\"0\" "
        "izz=\"0.1\"/></inertial></link>\n<link name=\"arm\"><inertial><inertia ixx=\"5\" "
        "ixy=\"0\" ixz=\"0\" iyy=\"3\" iyz=\"0\" "
        "izz=\"1\"/></inertial></link></robot>");
  EXPECT_EQ(*from("file = \"a.urdf\"\nlink = \"base\"").body.axes->rational_moments(),
            (rational_vector{rational(3, 10), rational(1, 5), rational(1, 10)}));
  const scene arm = from("file = \"a.urdf\"\nlink = \"arm\"");
  EXPECT_EQ(arm.body.axes->margin().exact(), -1);
  ASSERT_FALSE(arm.remarks.empty());
  EXPECT_NE(arm.remarks[0].find("5 is above the sum of the others 4 by 1"), std::string::npos)
      << arm.remarks[0];
  write("b.sdf",
        "<sdf><model><link name='l'><inertial><inertia><ixx>3</ixx><iyy> 2 "
        "</iyy><izz>1</izz></inertia></inertial></link></model></sdf>");
  EXPECT_EQ(*from("file = \"b.sdf\"").body.axes->rational_moments(), (rational_vector{3, 2, 1}));
  write("c.xml",
        "<mujoco><worldbody><body name='x'><inertial pos='0 0 0' mass='1' fullinertia='26 38 35 4 "
        "-10 -14'/></body></worldbody></mujoco>");
  EXPECT_EQ(*from("file = \"c.xml\"").body.axes->rational_moments(), (rational_vector{54, 27, 18}));
  write("d.xml", "<mujoco><body name='x'><inertial mass='1' diaginertia='1 2'/></body></mujoco>");
  write("e.json", "{\"moments\": [3, 2, 0.1], \"sigma\": [1, 1, 0.01]}");
  EXPECT_EQ(from("file = \"e.json\"").body.kind, body_kind::undecided);
  const auto refused = [&](const std::string& keys, const std::vector<std::string>& words) {
    std::string why = "accepted";
    try {
      (void)from(keys);
    } catch (const input_error& error) {
      why = error.what();
    }
    for (const std::string& word : words)
      EXPECT_NE(why.find(word), std::string::npos) << word << " in: " << why;
  };
  refused("file = \"a.urdf\"", {"line 2", "choose the link", "base", "arm"});
  refused("file = \"a.urdf\"\nlink = \"leg\"", {"\"leg\"", "arm"});
  refused("file = \"d.xml\"", {"diaginertia must be 3 numbers"});
  refused("file = \"missing.sdf\"", {"No such file"});
  refused("file = \"a.stl\"", {".urdf"});
  write("f.sdf", "<sdf><a>");
  refused("file = \"f.sdf\"", {"no XML"});
  // Frames that are not turned.
  const auto posed = [](const std::string& pose) {
    return "<sdf><model><link name='l'><inertial>" + pose +
           "<inertia><ixx>3</ixx><iyy>2</iyy><izz>1</izz></inertia></inertial></link></model></"
           "sdf>";
  };
  const auto is_turned = [&](const std::string& name, const std::string& text) {
    write(name, text);
    const scene s = from("file = \"" + name + "\"");
    EXPECT_EQ(*s.body.axes->rational_moments(), (rational_vector{3, 2, 1})) << text;
    EXPECT_TRUE(s.remarks.empty()) << text;
    const std::array<rational, 6> diagonal{3, 2, 1, 0, 0, 0};
    return !s.body.turn.is_identity() || s.body.axes->tensor() != diagonal;
  };
  const std::string frame = "<pose rotation_format='quat_xyzw'>";
  EXPECT_FALSE(is_turned("i.sdf", posed(frame + "1 2 3 0 0 0 1</pose>")));
  EXPECT_FALSE(is_turned("i.sdf", posed(frame + "1 2 3 0 0 0 -2</pose>")));
  EXPECT_FALSE(is_turned("i.sdf", posed("<pose degrees='true'>1 2 3 0 360 0</pose>")));
  EXPECT_FALSE(is_turned("i.sdf", posed("<pose rotation_format='euler_rpy'>1 2 3 0 0 0</pose>")));
  for (const char* identity : {"euler='0 0 0'", "axisangle='1 2 3 0'", "xyaxes='2 0 0 1 3 0'",
                               "zaxis='0 0 2'", "quat='-2 0 0 0'"}) {
    EXPECT_FALSE(is_turned("i.xml", std::string("<mujoco><body><inertial ") + identity +
                                        " diaginertia='3 2 1'/></body></mujoco>"))
        << identity;
  }
  // What a program for drawing leaves of an angle of 0 is taken as it is written.
  EXPECT_TRUE(is_turned("i.sdf", posed(frame + "1 2 3 1e-16 0 0 1</pose>")));
  EXPECT_TRUE(is_turned("i.sdf", posed("<pose>1 2 3 0 -1e-16 0</pose>")));
  EXPECT_TRUE(is_turned("i.urdf",
                        "<robot><link><inertial><origin rpy='0 0 1e-12'/><inertia ixx='3' "
                        "iyy='2' izz='1'/></inertial></link></robot>"));
  EXPECT_TRUE(is_turned("i.xml",
                        "<mujoco><body><inertial quat='1 0 -1e-17 0' mass='1' "
                        "diaginertia='3 2 1'/></body></mujoco>"));
  // Half a turn about (1, 0, 1): x and z change places, and y is turned about.
  write("j.sdf", posed(frame + "1 2 3 0.5 0 0.5 0</pose>"));
  EXPECT_EQ(from("file = \"j.sdf\"").body.axes->tensor(),
            (std::array<rational, 6>{1, 2, 3, 0, 0, 0}));
  // By 2 atan(1/2) about z: the cosine is 3/5, the sine 4/5.
  write("j.xml", "<mujoco><body><inertial quat='2 0 0 1' diaginertia='3 2 1'/></body></mujoco>");
  EXPECT_EQ(from("file = \"j.xml\"").body.axes->tensor(),
            (std::array<rational, 6>{rational(3 * 9 + 2 * 16, 25), rational(3 * 16 + 2 * 9, 25), 1,
                                     rational(12, 25), 0, 0}));
  for (const auto& [pose, word] :
       {std::pair(frame + "1 2 3 0 0 0</pose>", "must have 7"),
        std::pair(frame + "0 0 0 0 0 0 0</pose>", "must not be 0"),
        std::pair(std::string("<pose rotation_format='rpy'>1 2 3 0 0 0</pose>"), "euler_rpy"),
        std::pair(std::string("<pose relative_to='other'>1 2 3 0 0 0</pose>"), "relative_to"),
        std::pair(std::string("<pose>1 2 3 0 1e-11</pose>"), "must have 6")}) {
    write("j.sdf", posed(pose));
    refused("file = \"j.sdf\"", {"line 1", word});
  }
  write("k.xml",
        "<mujoco><body><inertial quat='2 0 0 1' euler='1 0 0' diaginertia='3 2 "
        "1'/></body></mujoco>");
  refused("file = \"k.xml\"", {"line 1", "turned twice"});
  write("l.xml",
        "<mujoco><body><inertial quat='2 0 0 1' fullinertia='3 2 1 0 0 "
        "0'/></body></mujoco>");
  refused("file = \"l.xml\"", {"line 1", "fullinertia"});
  write("g.urdf", std::string(100'000, '<') + "a");
  refused("file = \"g.urdf\"", {"no XML"});
  std::string deep;
  for (int i = 0; i < 200'000; ++i) deep += "<a>";
  for (int i = 0; i < 200'000; ++i) deep += "</a>";
  write("h.urdf", deep);
  refused("file = \"h.urdf\"", {"no inertia"});
}

// A scene is read several times by the program; a file that it names must be the same each time.
/// Every way in which a file turns a frame, beside the same rotation by a quaternion: quarter and
/// half turns, and turns of rational sines, which are exact in both.
TEST(SceneBody, TurnedFrames) {
  const support::scratch_directory directory;
  const auto body_of = [&](const std::string& name, const std::string& text) {
    std::ofstream(directory.path(name)) << text;
    return read_scene("[body]\nfile = \"" + name + "\"\n" + wanting, directory.path("")).body;
  };
  const std::string entries =
      "<ixx>5</ixx><iyy>4</iyy><izz>3</izz><ixy>0.1</ixy><ixz>0.2</ixz><iyz>0.3</iyz>";
  const auto sdf = [&](const std::string& pose) {
    return body_of("f.sdf", "<sdf><model><link name='l'><inertial>" + pose + "<inertia>" + entries +
                                "</inertia></inertial></link></model></sdf>");
  };
  const auto urdf = [&](const std::string& turn) {
    return body_of("f.urdf", "<robot><link name='l'><inertial><origin " + turn +
                                 "/><inertia ixx='5' iyy='4' izz='3' ixy='0.1' ixz='0.2' "
                                 "iyz='0.3'/></inertial></link></robot>");
  };
  const auto mjcf = [&](const std::string& turn, const std::string& compiler = "") {
    return body_of("f.xml", "<mujoco>" + compiler + "<worldbody><body><inertial " + turn +
                                " diaginertia='5 4 3'/></body></worldbody></mujoco>");
  };
  const auto expect_exactly = [](const scene_body& x, const scene_body& y, const char* what) {
    EXPECT_TRUE(x.turn.is_identity()) << what;
    EXPECT_EQ(x.axes->tensor(), y.axes->tensor()) << what;
  };
  // Roll, then pitch, then yaw, about axes that are fixed.
  const auto of_pose = [&](const char* q) {
    return sdf("<pose rotation_format='quat_xyzw'>0 0 0 " + std::string(q) + "</pose>");
  };
  const auto in_degrees = [&](const char* angles) {
    return sdf("<pose degrees='true'>0 0 0 " + std::string(angles) + "</pose>");
  };
  expect_exactly(in_degrees("90 0 0"), of_pose("1 0 0 1"), "roll");
  expect_exactly(urdf("quat_xyzw='1 2 3 4'"), of_pose("1 2 3 4"), "a quaternion of URDF");
  EXPECT_THROW((void)urdf("rpy='0 0 1' quat_xyzw='1 2 3 4'"), input_error);
  expect_exactly(in_degrees("0 90 0"), of_pose("0 1 0 1"), "pitch");
  expect_exactly(in_degrees("0 0 90"), of_pose("0 0 1 1"), "yaw");
  expect_exactly(in_degrees("0 0 -90"), of_pose("0 0 -1 1"), "yaw back");
  // The quaternion (1 + k)(1 + j)(1 + i)/sqrt 8 of yaw, pitch and roll: 2 j + 2 over that.
  expect_exactly(in_degrees("90 90 90"), of_pose("0 1 0 1"), "all three");
  // (1 + j)(1 + i) = 1 + i + j - k.
  expect_exactly(in_degrees("90 90 0"), of_pose("1 1 -1 1"), "roll and pitch");
  // MuJoCo's: in degrees, unless the compiler says otherwise; about axes that turn.
  expect_exactly(mjcf("euler='90 0 0'"), mjcf("quat='1 1 0 0'"), "euler");
  expect_exactly(mjcf("euler='0 0 -90'"), mjcf("quat='1 0 0 -1'"), "euler");
  // (1 + i)(1 + j) = 1 + i + j + k; capital letters are of fixed axes: (1 + j)(1 + i).
  expect_exactly(mjcf("euler='90 90 0'"), mjcf("quat='1 1 1 1'"), "xyz");
  expect_exactly(mjcf("euler='90 90 0'", "<compiler eulerseq='XYZ'/>"), mjcf("quat='1 1 1 -1'"),
                 "XYZ");
  expect_exactly(mjcf("euler='90 0 90'", "<compiler eulerseq='zxX'/>"), mjcf("quat='1 1 -1 1'"),
                 "a fixed axis after others");
  expect_exactly(mjcf("euler='90 90 0'", "<compiler eulerseq='XYZ' angle='degree'/>"),
                 mjcf("quat='1 1 1 -1'"), "degree");
  expect_exactly(mjcf("axisangle='1 2 2 180'"), mjcf("quat='0 1 2 2'"), "half a turn");
  expect_exactly(mjcf("axisangle='0 0 -3 90'"), mjcf("quat='1 0 0 -1'"), "axisangle");
  expect_exactly(mjcf("xyaxes='3 4 0 -1 1 0'"), mjcf("quat='2 0 0 1'"), "xyaxes");
  // (0, 0, 1) goes to (0, -4/5, 3/5), about x by 2 atan(1/2).
  expect_exactly(mjcf("zaxis='0 -4 3'"), mjcf("quat='2 1 0 0'"), "zaxis");
  expect_exactly(mjcf("zaxis='0 0 -1'"), mjcf("quat='0 1 0 0'"), "zaxis");
  // Irrational turns: the principal axes as seen from the link, by R_z R_y R_x.
  constexpr precision p = 100;
  const auto turned = [&](std::size_t axis, const char* angle, const triple<ball>& v) {
    const ball x = parse_ball(angle, p);
    triple<ball> result = v;
    result[(axis + 1) % 3] = cos(x) * v[(axis + 1) % 3] - sin(x) * v[(axis + 2) % 3];
    result[(axis + 2) % 3] = sin(x) * v[(axis + 1) % 3] + cos(x) * v[(axis + 2) % 3];
    return result;
  };
  const scene_body plain = urdf("rpy='0 0 0'");
  const scene_body by_angles = urdf("rpy='0.1 -0.2 0.3'");
  const scene_body of_sdf = sdf("<pose>7 8 9 0.1 -0.2 0.3</pose>");
  for (std::size_t i = 0; i < 3; ++i) {
    const triple<ball> expected =
        turned(2, "0.3", turned(1, "-0.2", turned(0, "0.1", plain.axes->axis(i, p))));
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_TRUE(overlaps(by_angles.principal_axis(i, p)[k], expected[k])) << i << k;
      EXPECT_TRUE(overlaps(of_sdf.principal_axis(i, p)[k], expected[k])) << i << k;
    }
    EXPECT_TRUE(overlaps(by_angles.moments()[i].at(p), plain.moments()[i].at(p)));
  }
  // One bad frame costs only its own link.
  const std::string two =
      "<sdf><model><link name='a'><inertial><pose relative_to='b'>0 0 0 1 2 3</pose><inertia>" +
      entries + "</inertia></inertial></link><link name='b'><inertial><inertia>" + entries +
      "</inertia></inertial></link></model></sdf>";
  std::ofstream(directory.path("two.sdf")) << two;
  const auto link_of_two = [&](const char* link) {
    return read_scene(
        "[body]\nfile = \"two.sdf\"\nlink = \"" + std::string(link) + "\"\n" + wanting,
        directory.path(""));
  };
  EXPECT_EQ(link_of_two("b").body.axes->tensor(), plain.axes->tensor());
  EXPECT_THROW((void)link_of_two("a"), input_error);
  const scene_body radians = mjcf("euler='0.1 -0.2 0.3'", "<compiler angle='radian'/>");
  const triple<ball> x =
      turned(0, "0.1", turned(1, "-0.2", turned(2, "0.3", {ball(1, p), ball(0, p), ball(0, p)})));
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_TRUE(overlaps(radians.principal_axis(0, p)[k], x[k])) << k;
  }
  for (const auto& [turn, compiler, word] :
       {std::tuple("xyaxes='1 2 3 2 4 6'", "", "parallel"),
        std::tuple("zaxis='0 0 0'", "", "zaxis"),
        std::tuple("axisangle='0 0 0 1'", "", "axisangle"),
        std::tuple("euler='1 2 3'", "<compiler eulerseq='xyw'/>", "eulerseq"),
        std::tuple("euler='1 2 3'", "<compiler eulerseq='xy'/>", "eulerseq")}) {
    try {
      (void)mjcf(turn, compiler);
      ADD_FAILURE() << turn << " was accepted";
    } catch (const input_error& error) {
      EXPECT_NE(std::string_view(error.what()).find(word), std::string_view::npos) << error.what();
    }
  }
}

TEST(SceneBody, ImportedFilesAreReadOnce) {
  const support::scratch_directory directory;
  const std::string path = directory.path("body.json");
  std::ofstream(path) << R"({"moments": [3, 2, 1]})";
  const std::string text = "[body]\nfile = \"body.json\"\n" + wanting;
  text_files files;
  const scene first = read_scene(text, directory.path(""), {}, files);
  std::filesystem::remove(path);
  const scene second = read_scene(text, directory.path(""), {}, files);
  EXPECT_EQ(*first.body.axes->rational_moments(), *second.body.axes->rational_moments());
  EXPECT_THROW((void)read_scene(text, directory.path("")), input_error);
}

TEST(SceneBody, OnlyRegularFiles) {
  const support::scratch_directory directory;
  const std::string pipe = directory.path("pipe.json");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const auto refused = [&](const std::string& path) -> std::string {
    try {
      (void)read_text_file(path);
    } catch (const input_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refused(pipe).find("regular file"), std::string::npos);  // and it does not wait
  EXPECT_NE(refused(directory.path("")).find("directory"), std::string::npos);
  EXPECT_NE(refused("/dev/zero").find("regular file"), std::string::npos);
  EXPECT_NE(refused(directory.path("none")).find("No such file"), std::string::npos);
}

TEST(SceneBody, Refusals) {
  expect_refused(wanting, {"no [body]"});
  expect_refused("[body]\n" + wanting, {"no body"});
  expect_refused(with_body("moments = [3, 2, 1]\nab = [1, 0.1]"), {"given twice"});
  expect_refused(with_body("moments = [3, -2, 1]"), {"line 2", "-2 is not positive"});
  expect_refused(with_body("moments = [3, 2]"), {"line 2", "array of 3"});
  expect_refused(with_body("moments = [3, 2, true]"), {"body.moments[2]", "boolean"});
  expect_refused(with_body("moment = [3, 2, 1]"), {"line 2", "\"moment\"", "\"moments\""});
  expect_refused(with_body("moments = [3, 2, 1]\nunit = \"kg m2\""), {"line 3", "\"kg m^2\""});
  expect_refused(with_body("moments = [3, 2, 1]\nsigma = [1, 1, -1]"), {"sigma"});
  expect_refused(with_body("moments = [\"3 ± 1\", 2, 1]\nsigma = [1, 1, 1]"),
                 {"line 2", "one of them"});
  expect_refused(with_body("moments = [\"3 ± -1\", 2, 1]"), {"negative"});
  expect_refused(with_body("ab = [1, 2]"), {"b = 2"});
  expect_refused(with_body("tensor = [[1, 0, 1], [0, 1, 0], [0, 0, 1]]"), {"symmetric"});
  expect_refused(with_body("tensor = [[1, 2, 0], [2, 1, 0], [0, 0, 1]]"), {"not positive"});
  expect_refused("moments = [3, 2, 1]\n" + wanting,
                 {"line 1", "\"moments\"", "not known in a scene"});
  expect_refused("[body\n", {"line 1", "no TOML"});
  std::string dotted = "x = 1\na";
  for (int i = 0; i < 100'000; ++i) dotted += ".a";
  expect_refused(dotted + " = 1\n", {"line 2", "parts"});
  expect_refused("b = {" + dotted.substr(6) + " = 1}\n", {"line 1", "parts"});
  expect_refused("[" + dotted.substr(6) + "]\n", {"line 1", "parts"});
  expect_refused("a = " + std::string(100'000, '['), {"line 1", "no TOML"});
  expect_refused(with_body("moments = [0." + std::string(200, '1') + ", 2, 1]"),
                 {"line 2", "in quotes"});
  EXPECT_EQ(read("title = \"....................\" # ....................\n" +
                 with_body("moments = [3, 2, 1]"))
                .title.size(),
            20U);
  expect_refused("[body]\nmoments=[3,2,1]\nmoments=[3,2,1]\n", {"line 3"});
}

TEST(SceneTime, CountsJulianDatesFromTheEpoch) {
  const std::string start =
      "[body]\nmoments = [3, 2, 1]\n[state]\nomega = [0, 1, 0.1]\nunit = \"rad/s\"\n[time]\n";
  const scene dated =
      read(start + "epoch = 2448965.5\nfrom = 2448965.75\nto = 2448970.5\n" + wanting);
  EXPECT_EQ(dated.time->from, rational(1, 4));
  EXPECT_EQ(dated.time->to, 5);
  EXPECT_EQ(dated.time_unit.name, "day");
  EXPECT_EQ(read(start + "epoch = 10\nto = 12\nunit = \"day\"\n" + wanting).time->from, 0);
  expect_refused(start + "epoch = 10\nto = 12\nunit = \"s\"\n" + wanting, {"Julian", "\"day\""});
  expect_refused(start + "epoch = 10\nto = 9\n" + wanting, {"before"});
}

TEST(SceneBody, KnowsAtomicUnits) {
  const scene water = read(with_body("moments = [0.6, 1.15, 1.76]\nunit = \"u Å^2\""));
  EXPECT_EQ(water.body.size.factor, parse_rational("1.66053906892e-47"));
  EXPECT_EQ(read(with_body("moments = [3, 2, 1]\nunit = \"u A^2\"")).body.size.factor,
            water.body.size.factor);
}

TEST(SceneState, TurnsIntoC) {
  const auto c_of = [](const std::string& state) {
    return read("[body]\nmoments = [3, 2, 1]\n[state]\n" + state + "\n" + wanting)
        .state->motion->c()
        .exact();
  };
  // J = (3, 2, 1): 2H = 6, J^2 = 14, c = 2*6/14 - 1.
  EXPECT_EQ(c_of("omega = [1, 1, 1]"), rational(-1, 7));
  EXPECT_EQ(c_of("omega = [7, 7, 7]\nunit = \"deg/day\""), rational(-1, 7));
  EXPECT_EQ(c_of("momentum = [3, 2, 1]"), rational(-1, 7));
  EXPECT_EQ(c_of("omega = [0, 5, 0]"), 0);
  EXPECT_EQ(c_of("c = 0.5"), rational(1, 2));
  // The same in turned axes.
  const scene turned = read(
      "[body]\ntensor = [[26, 4, -10], [4, 38, -14], [-10, -14, 35]]\n[state]\nomega = [1, -1, "
      "5]\n" +
      wanting);
  const scene again = read(
      "[body]\nmoments = [18, 27, 54]\n[state]\nomega = [\"11/3\", \"1/3\", \"11/3\"]\n" + wanting);
  EXPECT_EQ(turned.state->motion->c(), again.state->motion->c());
}

TEST(SceneState, AttitudeByMatrix) {
  const scene s = read(
      "[body]\nmoments = [3, 2, 1]\n[state]\nomega = [1, 0, 0]\n"
      "matrix = [[\"3/5\", \"-4/5\", 0], [\"4/5\", \"3/5\", 0], [0, 0, 1]]\n" +
      wanting);
  ASSERT_TRUE(s.state->matrix);
  EXPECT_EQ((*s.state->matrix)[0][1], rational(-4, 5));
  EXPECT_EQ((*s.state->matrix)[1][0], rational(4, 5));
}

TEST(SceneState, Refusals) {
  const auto refused = [](const std::string& state, const std::vector<std::string>& words,
                          const std::string& body = "moments = [3, 2, 1]") {
    expect_refused("[body]\n" + body + "\n[state]\n" + state + "\n" + wanting, words);
  };
  refused("omega = [0, 0, 0]", {"line 4", "does not turn"});
  refused("omega = [1, 0, 0]\nmomentum = [1, 0, 0]", {"line 3", "given twice"});
  refused("unit = \"rad/s\"", {"no state"});
  refused("omega = [1, 0, 0]\nunit = \"deg/fortnight\"", {"line 5", "fortnight", "one of"});
  refused("momentum = [1, 0, 0]\nunit = \"kg m^2/s\"", {"contradictory"});
  refused("momentum = [1, 0, 0]", {"contradictory"}, "moments = [3, 2, 1]\nunit = \"kg m^2\"");
  refused("c = 2", {"line 4", "a = 1"});
  refused("c = 0.1\nunit = \"rad/s\"", {"line 5", "contradictory"});
  refused("omega = [1, 0, 0]\nmatrix = [[1, 0, 0], [0, 1, 0], [0, 0.001, 1]]",
          {"line 5", "rows 2 and 3", "the product 1/1000", "quaternion"});
  refused("omega = [1, 0, 0]\nmatrix = [[1, 0, 0], [0, 1, 0], [0, 0, -1]]", {"reflection"});
  refused("omega = [1, 0, 0]\nquaternion = [0, 0, 0, 0]", {"line 5", "must not be 0"});
  refused("omega = [1, 0, 0]\nquaternion = [1, 0, 0, 0]\neuler = [1, 2, 3]", {"given twice"});
  refused("omega = [1, 0, 0]\neuler = [1, 2, 3]", {"euler_unit"});
  refused("omga = [1, 0, 0]", {"line 4", "\"omga\"", "\"omega\""});
  refused("c = 0.1", {"three different"}, "moments = [2, 2, 1]");
}

TEST(SceneEffects, Refusals) {
  const std::string body = "[body]\nmoments = [3, 2, 1]\n";
  expect_refused(body, {"no [effects]"});
  expect_refused(body + "[effects]\nwant = []", {"line 4", "empty"});
  expect_refused(body + "[effects]\nwant = [\"perod\"]", {"line 4", "perod", "\"period\""});
  expect_refused(body + "[effects]\nwant = [\"period\"]", {"line 4", "period", "needs a state"});
  expect_refused(body + "[state]\nc = 0.1\n[effects]\nwant = [\"flips\"]",
                 {"line 6", "flips", "omega or momentum"});
  expect_refused(body + "[state]\nomega = [1, 1, 1]\n[effects]\nwant = [\"attitude\"]",
                 {"needs a time"});
  expect_refused(body + "[effects]\nwant = [\"planarity\"]\npints = 3", {"line 5", "\"points\""});
  expect_refused(body + "[effects]\nwant = [\"twist_curve\"]\nc = [0.1, 0]", {"line 5", "below"});
  expect_refused("[body]\nmoments = [2, 2, 1]\n[effects]\nwant = [\"tennis_racket\"]",
                 {"symmetric top"});
  expect_refused("digits = 0\n" + body + wanting, {"line 1", "from 1"});
  expect_refused("precision = \"double\"\ndigits = 3\n" + body + wanting, {"contradictory"});
  expect_refused(body + "[time]\nto = 1\nunit = \"s\"\n" + wanting, {"contradictory units"});
  expect_refused(body + "[time]\nepoch = 1\nto = 2\n" + wanting, {"epoch", "contradictory units"});
  expect_refused(body + "[time]\nfrom = 2\nto = 1\n" + wanting, {"before the beginning"});
  expect_refused(body + "[time]\nto = 1\nsamples = 100000000\n" + wanting, {"samples"});
}

TEST(SceneSweep, ReplacesAnyNumber) {
  const std::string text = "[body]\nmoments = [3, 2, 1]\n[state]\nomega = [1, 1, 1]\n" + wanting +
                           "[sweep]\n\"state.omega[1]\" = { from = 0, to = 1, steps = 4 "
                           "}\n\"body.moments[0]\" = [3, \"7/2\"]\n";
  const scene whole = read(text);
  ASSERT_EQ(whole.sweep.size(), 2U);
  EXPECT_EQ(whole.sweep[0].values,
            (std::vector<rational>{0, rational(1, 4), rational(1, 2), rational(3, 4), 1}));
  const scene point = read_scene(text, ".", {{"body.moments[0]", rational(7, 2)}});
  EXPECT_EQ((*point.body.axes->rational_moments())[0], rational(7, 2));
  expect_refused("[body]\nmoments = [3, 2, 1]\n" + wanting + "[sweep]\n\"body.moment[0]\" = [1]\n",
                 {"line 6", "body.moments[0]"});
  expect_refused("[body]\nmoments = [3, 2, 1]\n" + wanting + "[sweep]\n\"body.moments[0]\" = []\n",
                 {"line 6", "at least one"});
  EXPECT_NE(refusal(text, {{"body.moments[2]", -1}}).find("-1 is not positive"), std::string::npos);
}

}  // namespace scene_test
}  // namespace polhode
