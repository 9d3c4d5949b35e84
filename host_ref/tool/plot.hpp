#pragma once
// The main mass's displacement with and without absorber, as the paper's figures show it, drawn by gnuplot.

#include <host_ref/simulation.hpp>
#include <string>
#include <vector>

namespace impact::host {

// A curve of any length in about a thousand points, as many as the plot has pixels. They are the lowest and the highest
// value of each group of steps, so that no peak is lost.
class Curve {
 public:
  explicit Curve(long steps) : steps_per_run_(steps / 500 + 1) {}

  void add(double t, double x) {
    const Point point{t, x};
    if (in_run_ == 0) points_.insert(points_.end(), {point, point});
    Point &first = points_[points_.size() - 2], &second = points_.back();
    const Point &low = first.x < second.x ? first : second, &high = first.x < second.x ? second : first;
    if (x < low.x) {
      first = high;
      second = point;
    } else if (x > high.x) {
      first = low;
      second = point;
    }
    in_run_ = (in_run_ + 1) % steps_per_run_;
  }

  struct Point {
    double t, x;
  };
  const std::vector<Point>& points() const { return points_; }

 private:
  long steps_per_run_, in_run_ = 0;
  std::vector<Point> points_;
};

// Without gnuplot it prints this on standard error and draws nothing.
void draw(const std::string& path, const Request& request, const Curve& with_absorber, const Curve& without_absorber);

}  // namespace impact::host
