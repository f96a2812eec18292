// What the settings of a study differ in, against its reference and against the scatter over seeds.
//
// Every quantity is a curve of some points, a number being one point. Runs of the same seed begin
// with the same stones in the same places and are paired: of n seeds that both have,
//   error = rms over the points of the mean over seeds of (setting - reference) / size,
//   noise = t / sqrt(n) x rms over the points of the standard deviation of that difference / size,
// with the rms of the reference's mean as size, and t for n - 1 degrees of freedom and 95 %
// (Student, 1908). A difference that is nothing but chance stays below the noise in 19 of 20 cases:
// what is inside it is not told from chance. Where all is zero, in each of n seeds of both, nothing
// scatters, and yet what happens up to 3 / n times in a run may have stayed away: exp(-3) is one in
// 20 (the rule of three, Hanley and Lippman-Hand, 1983). That, over the size, is the noise then.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace apps {

struct Quantity {
  std::string name;    // "mould traction, peak"
  std::string column;  // of the history
  // per_decade: slope over the logarithm of the abscissa beyond its first half unit, every part of
  // a decade counting alike.
  enum Take { last, mean, largest, smallest, curve, per_decade } take;
  double least_size;  // below it differences are told in its parts [unit of the column]
};

// Of a program; the abscissa is the column that its curves are drawn over.
struct Interest {
  std::string abscissa;
  std::vector<Quantity> quantities;
};
Interest interest_of(const std::string& program);

constexpr int curve_points = 200;

// What one run found: the points of every quantity, none where its history lacks the column.
using Found = std::vector<std::vector<double>>;
Found read_found(const std::string& results, const Interest& interest);

struct Judgement {
  double error = 0;    // [-]
  int sign = 0;        // of the difference where it is of one number: 1 or -1
  double noise = 0;    // [-]
  bool known = false;  // false: a run lacks the quantity, or fewer than two seeds are common
  int none_in = 0;     // runs of each of the two, where no run has any
  bool beyond() const { return known && error > noise; }
};

// The points of one quantity by seed.
using BySeed = std::map<int, std::vector<double>>;
Judgement judge(const BySeed& setting, const BySeed& reference, double least_size);
// How much two means like the reference's own differ by chance, with no pairs: all noise.
Judgement scatter(const BySeed& reference, double least_size);

}  // namespace apps
