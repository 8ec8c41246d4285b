#include "bench/support/report.h"

#include "bench/support/provenance.h"
#include "bench/support/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace rasterlab::bench {
namespace {

const char* name_of(Role role) {
  switch (role) {
    case Role::peer:
      return "peer";
    case Role::limit:
      return "limit";
    case Role::rung:
      break;
  }
  return "rung";
}

/// The peer's samples, or none.
std::vector<double> peer_samples(const MeasuredLadder& measured) {
  for (std::size_t i = 0; i < measured.samples.size(); ++i) {
    if (measured.ladder.rungs[i].role == Role::peer) return measured.samples[i];
  }
  return {};
}

/// The peer's time by ours, repetition by repetition.
std::vector<double> ratios(const std::vector<double>& peer, const std::vector<double>& ours) {
  std::vector<double> quotients;
  for (std::size_t i = 0; i < std::min(peer.size(), ours.size()); ++i) {
    quotients.push_back(peer[i] / ours[i]);
  }
  return quotients;
}

std::string format(const char* pattern, double value) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), pattern, value);
  return buffer.data();
}

std::string padded(const std::string& text, std::size_t width, bool left = false) {
  const std::string space(width - std::min(width, text.size()), ' ');
  return left ? text + space : space + text;
}

nlohmann::ordered_json rung_to_json(const MeasuredLadder& measured, std::size_t index) {
  const TimedLadder& ladder = measured.ladder;
  const TimedRung& rung = ladder.rungs[index];
  const std::vector<double>& samples = measured.samples[index];
  nlohmann::ordered_json errors = nlohmann::ordered_json::object();
  for (const auto& [name, value] : rung.errors) errors[name] = value;
  nlohmann::ordered_json object = {{"ladder", ladder.name},
                                   {"stage", ladder.stage},
                                   {"unit", ladder.unit},
                                   {"rung", rung.name},
                                   {"role", name_of(rung.role)},
                                   {"fault", rung.fault},
                                   {"ns_median", median(samples)},
                                   {"ns_min", smallest(samples)},
                                   {"ns_spread", spread(samples)},
                                   {"repetitions", samples.size()},
                                   {"errors", errors},
                                   {"plotted_error", ladder.error},
                                   {"commit", commit()},
                                   {"machine", machine()}};
  const std::vector<double> peer = peer_samples(measured);
  if (!peer.empty()) {
    const std::vector<double> quotients = ratios(peer, samples);
    object["ratio"] = {{"median", median(quotients)}, {"spread", spread(quotients)}};
  }
  return object;
}

}  // namespace

nlohmann::ordered_json to_json(const std::vector<MeasuredLadder>& measured) {
  nlohmann::ordered_json array = nlohmann::ordered_json::array();
  for (const MeasuredLadder& one : measured) {
    for (std::size_t i = 0; i < one.samples.size(); ++i) array.push_back(rung_to_json(one, i));
  }
  return array;
}

std::string table(const MeasuredLadder& measured) {
  constexpr std::size_t name_width = 26;
  constexpr std::size_t width = 10;
  const TimedLadder& ladder = measured.ladder;
  const std::vector<double> peer = peer_samples(measured);
  const Errors& titles = ladder.rungs.back().errors;
  std::string text = ladder.name + ": nanoseconds per " + ladder.unit + ", and errors\n";
  text += padded("  rung", name_width, true);
  for (const char* title : {"median", "min", "spread"}) text += padded(title, width);
  if (!peer.empty()) text += padded("ratio", width) + padded("spread", width);
  for (const auto& [name, value] : titles) text += "  " + padded(name, width);
  text += "\n";
  for (std::size_t i = 0; i < measured.samples.size(); ++i) {
    const std::vector<double>& samples = measured.samples[i];
    text += padded("  " + ladder.rungs[i].name, name_width, true) +
            padded(format("%.3f", median(samples)), width) +
            padded(format("%.3f", smallest(samples)), width) +
            padded(format("%.0f%%", 100 * spread(samples)), width);
    if (!peer.empty()) {
      const std::vector<double> quotients = ratios(peer, samples);
      text += padded(format("%.2f", median(quotients)), width) +
              padded(format("%.0f%%", 100 * spread(quotients)), width);
    }
    for (const auto& [name, value] : ladder.rungs[i].errors) {
      text += "  " +
              padded(std::isnan(value) ? "-" : format("%.4g", value), std::max(width, name.size()));
    }
    text += "\n";
  }
  return text;
}

}  // namespace rasterlab::bench
