// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/samples_file.hpp>

#include <tegotae/lab/input_error.hpp>

#include <cmath>
#include <initializer_list>
#include <utility>

namespace tegotae {
namespace {

using Column = CsvColumn<TickRecord>;
using Columns = std::vector<Column>;

constexpr const char* kMeanings[] = {
    "t: time of the trajectory",
    "x to qz: pose of the tool's frame where the hand holds it, in the world",
    "fx to tz: the method's wrench on the interface before the safety stage, world axes",
    "tx to tz: torque about the tool's centre of mass",
    "dfx to dtz: the displayed wrench, after the safety stage, same axes and point: what an interface is commanded",
    "px to pqz: pose of the tool's frame where the world lets it be",
    "near_objects: bodies with a piece within reach; planes, contact_points: of the model",
    "constraints: contact points given to the solver; active: those of them that push",
    "status: 0 ok, 1 no model yet, 2 iteration limit, 3 infeasible, 4 invalid input",
    "safety_events, a sum: 1 not finite, 2 ramping, 4 rate limited, 8 force and 16 torque saturated",
    "safety_events, further: 32 physics late, 64 stopped, 128 waiting, 256 energy bounded, 512 tick late",
    "safety_events, and: 1024 pose fault, 2048 clutched, 4096 dead-man button",
    "deepest: greatest penetration of a contact point where the hand holds the tool",
    "model_age: since the world state that the model was made from; model_sequence: number of the model",
    "dropped: planes and points beyond the model's capacity",
    "tick_us: wall-clock time of the tick; the one column that does not repeat",
};
constexpr const char* kMeaningsInClosedLoop[] = {
    "ifx to itz: what the motors of the simulated interface really display, same axes and point",
    "hx to hqz: pose of the tool's frame where the hand means to hold it",
    "falls_short: 1 where the motors cannot display what is commanded",
};

// Adding zero turns a negative zero into zero.
template <class Member>
void add_vector(Columns& columns, std::initializer_list<const char*> names, const char* unit, Member member) {
  const char* const* name = names.begin();
  columns.push_back({*name++, unit, [member](const TickRecord& r) { return member(r).x + 0.0; }});
  columns.push_back({*name++, unit, [member](const TickRecord& r) { return member(r).y + 0.0; }});
  columns.push_back({*name, unit, [member](const TickRecord& r) { return member(r).z + 0.0; }});
}

void add_pose(Columns& columns, const std::string& prefix, PlainPose TickRecord::*pose) {
  const std::string x = prefix + "x", y = prefix + "y", z = prefix + "z";
  add_vector(columns, {x.c_str(), y.c_str(), z.c_str()}, "m", [pose](const TickRecord& r) { return (r.*pose).p; });
  columns.push_back({prefix + "qw", "", [pose](const TickRecord& r) { return (r.*pose).w + 0.0; }});
  const std::string qx = prefix + "qx", qy = prefix + "qy", qz = prefix + "qz";
  add_vector(columns, {qx.c_str(), qy.c_str(), qz.c_str()}, "", [pose](const TickRecord& r) { return r.*pose; });
}

void add_wrench(Columns& columns, const std::string& prefix, PlainWrench TickRecord::*wrench) {
  const std::string fx = prefix + "fx", fy = prefix + "fy", fz = prefix + "fz";
  add_vector(columns, {fx.c_str(), fy.c_str(), fz.c_str()}, "N",
             [wrench](const TickRecord& r) { return (r.*wrench).force; });
  const std::string tx = prefix + "tx", ty = prefix + "ty", tz = prefix + "tz";
  add_vector(columns, {tx.c_str(), ty.c_str(), tz.c_str()}, "N m",
             [wrench](const TickRecord& r) { return (r.*wrench).torque; });
}

template <class Number>
void add_number(Columns& columns, const char* name, const char* unit, Number TickRecord::*number) {
  columns.push_back({name, unit, [number](const TickRecord& r) { return static_cast<double>(r.*number); }});
}

// The sum of a start and whole periods, without the rounding of the sum.
double to_nanoseconds(double time) { return std::round(time * 1e9) / 1e9 + 0.0; }

std::vector<std::string> with_meanings(std::vector<std::string> notes, SampleKind kind) {
  notes.insert(notes.end(), std::begin(kMeanings), std::end(kMeanings));
  if (kind == SampleKind::kClosedLoop) {
    notes.insert(notes.end(), std::begin(kMeaningsInClosedLoop), std::end(kMeaningsInClosedLoop));
  }
  return notes;
}

}  // namespace

std::vector<CsvColumn<TickRecord>> sample_columns(double start, SampleKind kind) {
  Columns columns;
  columns.push_back({"t", "s", [start](const TickRecord& r) { return to_nanoseconds(start + r.time); }});
  add_pose(columns, "", &TickRecord::X_WT);
  add_wrench(columns, "", &TickRecord::wrench);
  add_wrench(columns, "d", &TickRecord::displayed);
  add_pose(columns, "p", &TickRecord::X_WP);
  add_number(columns, "near_objects", "", &TickRecord::near_objects);
  add_number(columns, "planes", "", &TickRecord::planes);
  add_number(columns, "contact_points", "", &TickRecord::contact_points);
  add_number(columns, "constraints", "", &TickRecord::constraints);
  add_number(columns, "active", "", &TickRecord::active);
  add_number(columns, "solver_iterations", "", &TickRecord::solver_iterations);
  add_number(columns, "status", "", &TickRecord::status);
  add_number(columns, "safety_events", "", &TickRecord::safety_events);
  add_number(columns, "deepest", "m", &TickRecord::deepest);
  add_number(columns, "model_age", "s", &TickRecord::model_age);
  add_number(columns, "model_sequence", "", &TickRecord::model_sequence);
  add_number(columns, "dropped", "", &TickRecord::dropped);
  if (kind == SampleKind::kClosedLoop) {
    add_wrench(columns, "i", &TickRecord::interface_wrench);
    add_pose(columns, "h", &TickRecord::X_WH);
    add_number(columns, "falls_short", "", &TickRecord::falls_short);
  }
  add_number(columns, "tick_us", "us", &TickRecord::tick_us);
  return columns;
}

SamplesFile::SamplesFile(const std::filesystem::path& file, std::vector<std::string> notes, double start,
                         SampleKind kind)
    : recorder_(file.string(), sample_columns(start, kind), with_meanings(std::move(notes), kind)) {
  check();
}

void SamplesFile::write(const TickRecord& record) {
  recorder_.record(record);
  check();
}

void SamplesFile::close() {
  recorder_.close();
  check();
}

void SamplesFile::check() const {
  if (!recorder_.writer().ok()) throw InputError(recorder_.writer().error());
}

}  // namespace tegotae
