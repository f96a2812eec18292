#include "apps/pictures.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "apps/errors.h"

namespace {

using apps::Array;
using Doubles = std::vector<double>;
using Indices = std::vector<std::int64_t>;

class Pictures : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("pictures_test_" + std::to_string(::getpid())) / test->name();
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_.parent_path()); }

  std::string file(const std::string& name) const { return folder_ / name; }

 private:
  std::filesystem::path folder_;
};

std::string content(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

// RFC 4648, section 4, digit by digit.
std::string decoded(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned word = 0;
  int bits = 0;
  for (const char c : text) {
    const std::size_t value = digits.find(c);
    if (value == std::string::npos) break;  // padding
    word = word << 6 | static_cast<unsigned>(value);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(word >> bits & 255);
  }
  return bytes;
}

// The values of the data array of that name, and its opening tag.
template <class T>
std::vector<T> values(const std::string& xml, const std::string& name, std::string* tag = nullptr) {
  const std::size_t found = xml.find("Name=\"" + name + "\"");
  if (found == std::string::npos) throw std::out_of_range(name);
  const std::size_t open = xml.rfind('<', found), begin = xml.find('>', found) + 1;
  if (tag) *tag = xml.substr(open, begin - open);
  const std::string bytes = decoded(xml.substr(begin, xml.find('<', begin) - begin));
  std::uint64_t size = 0;
  std::memcpy(&size, bytes.data(), sizeof size);
  EXPECT_EQ(size, bytes.size() - sizeof size) << name;
  std::vector<T> out(size / sizeof(T));
  if (size > 0) std::memcpy(out.data(), bytes.data() + sizeof size, out.size() * sizeof(T));
  return out;
}

// XML 1.0, section 2.1: every element is closed in the order in which it was opened.
void expect_well_formed(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
    const std::size_t end = xml.find('>', at);
    ASSERT_NE(end, std::string::npos);
    const std::string tag = xml.substr(at + 1, end - at - 1);
    const std::string name = tag.substr(0, tag.find(' '));
    if (tag.front() == '?' || tag.back() == '/') continue;
    if (tag.front() != '/') {
      open.push_back(name);
      continue;
    }
    ASSERT_FALSE(open.empty()) << tag;
    ASSERT_EQ("/" + open.back(), name);
    open.pop_back();
  }
  EXPECT_TRUE(open.empty());
}

Doubles flat(const Eigen::Matrix3Xd& points) {
  return {points.data(), points.data() + points.size()};
}

TEST_F(Pictures, stones_come_back_bit_by_bit_with_their_quantities) {
  // VTK file formats, XML, binary inline arrays: float64 in, float64 out, no rounding is allowed.
  // 1 to 3 stones reach every padding of base64.
  for (int count = 0; count <= 3; ++count) {
    const Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Random(3, count);
    Doubles diameter, velocity;
    for (int i = 0; i < count; ++i) diameter.push_back(2e-3 + i / 3e3);
    for (int i = 0; i < 3 * count; ++i) velocity.push_back(std::sin(i));
    apps::write_points(file("stones.vtp"), points,
                       {{"diameter [m]", 1, diameter}, {"velocity [m/s]", 3, velocity}});
    const std::string xml = content(file("stones.vtp"));
    expect_well_formed(xml);
    EXPECT_NE(xml.find("<Piece NumberOfPoints=\"" + std::to_string(count) + "\" NumberOfVerts=\"" +
                       std::to_string(count) + "\">"),
              std::string::npos);
    std::string tag;
    EXPECT_EQ(values<double>(xml, "position [m]"), flat(points));
    EXPECT_EQ(values<double>(xml, "diameter [m]"), diameter);
    EXPECT_EQ(values<double>(xml, "velocity [m/s]", &tag), velocity);
    EXPECT_NE(tag.find("type=\"Float64\""), std::string::npos);
    EXPECT_NE(tag.find("NumberOfComponents=\"3\""), std::string::npos);
    Indices corners, ends;
    for (int i = 0; i < count; ++i) corners.push_back(i), ends.push_back(i + 1);
    EXPECT_EQ(values<std::int64_t>(xml, "connectivity"), corners);
    EXPECT_EQ(values<std::int64_t>(xml, "offsets"), ends);
  }
}

TEST_F(Pictures, a_hexahedron_keeps_its_corners_its_stress_and_the_names_of_its_components) {
  // VTK cell type 12; offsets are the ends of the cells.
  const apps::Surface cube = apps::box({0, 0, 0}, {1, 2, 3});
  const std::vector<int> corners = {0, 1, 3, 2, 4, 5, 7, 6};
  Doubles stress;
  for (int i = 0; i < 6 * 8; ++i) stress.push_back(1e6 * i);
  const std::vector<std::string> names = {"xx", "yy", "zz", "yz", "zx", "xy"};
  apps::write_hexahedra(file("mould.vtu"), cube.points, corners,
                        {{"stress [Pa]", 6, stress, names}});
  const std::string xml = content(file("mould.vtu"));
  expect_well_formed(xml);
  std::string tag;
  EXPECT_EQ(values<double>(xml, "position [m]"), flat(cube.points));
  EXPECT_EQ(values<std::int64_t>(xml, "connectivity"), Indices(corners.begin(), corners.end()));
  EXPECT_EQ(values<std::int64_t>(xml, "offsets"), Indices{8});
  EXPECT_EQ(values<std::uint8_t>(xml, "types"), std::vector<std::uint8_t>{12});
  EXPECT_EQ(values<double>(xml, "stress [Pa]", &tag), stress);
  EXPECT_NE(tag.find("ComponentName0=\"xx\" ComponentName1=\"yy\""), std::string::npos);
  EXPECT_NE(tag.find("ComponentName5=\"xy\""), std::string::npos);
}

TEST_F(Pictures, polygons_of_unequal_length_end_where_they_should) {
  // Offsets are running sums of the corner numbers: 3, 3 + 4.
  const apps::Surface surface{Eigen::Matrix3Xd::Random(3, 5), {{0, 1, 2}, {1, 2, 3, 4}}};
  apps::write_polygons(file("wall.vtp"), surface,
                       {{"pressure <mean> & \"peak\" [Pa]", 1, Doubles(5)}});
  const std::string xml = content(file("wall.vtp"));
  expect_well_formed(xml);
  EXPECT_EQ(values<std::int64_t>(xml, "connectivity"), (Indices{0, 1, 2, 1, 2, 3, 4}));
  EXPECT_EQ(values<std::int64_t>(xml, "offsets"), (Indices{3, 7}));
  EXPECT_EQ(values<double>(xml, "pressure &lt;mean&gt; &amp; &quot;peak&quot; [Pa]").size(), 5u);
}

// Area vector of a polygon: half the sum of cross products of its corners (Newell).
Eigen::Vector3d area(const apps::Surface& surface, const std::vector<int>& polygon) {
  Eigen::Vector3d twice = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector3d a = surface.points.col(polygon[i]);
    const Eigen::Vector3d b = surface.points.col(polygon[(i + 1) % polygon.size()]);
    twice += a.cross(b);
  }
  return twice / 2;
}

double total_area(const apps::Surface& surface) {
  double sum = 0;
  for (const auto& polygon : surface.polygons) sum += area(surface, polygon).norm();
  return sum;
}

TEST_F(Pictures, walls_have_the_area_of_their_polygons) {
  // Regular n-gon in a circle: perimeter 2 n r sin(pi/n), area (n/2) r^2 sin(2 pi/n); the tolerance
  // is rounding in a sum of 48 terms.
  const double r = 0.075, h = 0.2, pi = std::numbers::pi;
  const int n = 48;
  EXPECT_NEAR(total_area(apps::tube(r, -0.05, h - 0.05, n)), 2 * n * r * std::sin(pi / n) * h,
              1e-15);
  const Eigen::Vector3d centre(0.01, 0.02, 0.3),
      normal = Eigen::Vector3d(0.1, -0.2, 1).normalized();
  const apps::Surface plate = apps::disc(centre, normal, r, n);
  const double polygon = n / 2.0 * r * r * std::sin(2 * pi / n);
  EXPECT_NEAR((area(plate, plate.polygons[0]) - polygon * normal).norm(), 0, 1e-15);
  EXPECT_NEAR((plate.points.rowwise().mean() - centre).norm(), 0, 1e-15);
}

TEST_F(Pictures, a_box_is_closed_and_faces_outwards) {
  // Divergence theorem: area vectors of a closed surface sum to zero, sum x . A / 3 is its volume;
  // the tolerance is rounding.
  const apps::Surface room = apps::box({-1, 2, 0}, {1, 5, 4});
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double volume = 0;
  for (const auto& polygon : room.polygons) {
    sum += area(room, polygon);
    volume += room.points.col(polygon[0]).dot(area(room, polygon)) / 3;
  }
  EXPECT_NEAR(sum.norm(), 0, 1e-14);
  EXPECT_NEAR(volume, 2 * 3 * 4, 1e-13);
}

TEST_F(Pictures, a_series_is_valid_after_every_picture) {
  // ParaView guide, PVD file format: one DataSet per time, in a closed collection.
  apps::Series series(file("stones.pvd"));
  for (int i = 0; i < 3; ++i) {
    series.add(0.1 * i, "stones_" + std::to_string(i) + ".vtp");
    const std::string xml = content(file("stones.pvd"));
    expect_well_formed(xml);
    EXPECT_NE(xml.find("file=\"stones_" + std::to_string(i) + ".vtp\"/>"), std::string::npos);
    EXPECT_NE(xml.find("timestep=\"0\""), std::string::npos);
  }
  EXPECT_NE(content(file("stones.pvd")).find("timestep=\"0.2\""), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(file("stones.pvd.part")));
}

TEST_F(Pictures, a_continued_series_forgets_what_came_after_the_checkpoint) {
  // An unbroken series and one broken off at 0.5 s and continued from 0.2 s are the same file.
  apps::Series unbroken(file("unbroken.pvd"));
  for (int i = 0; i <= 6; ++i) unbroken.add(i / 10.0, std::to_string(i) + ".vtp");
  apps::Series broken(file("broken.pvd"));
  for (int i = 0; i <= 5; ++i) broken.add(i / 10.0, std::to_string(i) + ".vtp");
  apps::Series continued(file("broken.pvd"), 0.2);
  for (int i = 3; i <= 6; ++i) continued.add(i / 10.0, std::to_string(i) + ".vtp");
  EXPECT_EQ(content(file("broken.pvd")), content(file("unbroken.pvd")));
}

TEST_F(Pictures, a_folder_that_is_not_there_is_an_output_error) {
  // ENOENT of open(2).
  EXPECT_THROW(apps::write_points(file("missing/stones.vtp"), Eigen::Matrix3Xd(3, 0), {}),
               apps::OutputError);
}

}  // namespace
