// What 10, 100 and 10,000 cores would take, from what one takes: scale verify CLAIMS SAMPLES | scale certify FILE
// SCENE [PREFIX of parts].
#include "base/crew/scale.hpp"

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "base/crew/bytes.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "claims/verify/verify.hpp"
#include "records/certify/pieces.hpp"
#include "records/record/bicycle_records.hpp"

using namespace slipproof;

namespace {

double cpu_seconds(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// CPU seconds of this process that the work takes.
template <class Work>
double seconds_of(const Work& work) {
  const double begin = cpu_seconds(CLOCK_PROCESS_CPUTIME_ID);
  work();
  return cpu_seconds(CLOCK_PROCESS_CPUTIME_ID) - begin;
}

/// What MPI adds, of which one machine shows nothing: a message, and a byte of it, as of a network of 10 Gbit/s.
constexpr double a_message = 2e-6, a_byte = 0.8e-9;

struct StageTimes {
  std::vector<double> seconds;
  double bytes = 0;
};

/// Answers of a first run, and what they took.
struct Recorded {
  std::map<std::string, std::string, std::less<>> results;
  std::map<std::uint64_t, StageTimes> stages;  ///< by the number in the request that tells them apart
};

struct Measured {
  std::vector<MeasuredWork> stages;
  double alone = 0;  ///< between and after them
};

/// Runs the work with one thread that is timed, and again with the answers at hand, which leaves what rank 0 does.
/// `stage_of` tells the stage of a request.
template <class Answer, class Lead, class StageOf>
Measured measured(const Answer& answer, const Lead& lead, const StageOf& stage_of) {
  Recorded recorded;
  Alone alone;
  {
    Crew crew(alone, {.threads = 1}, [&](std::string_view request) {
      const double begin = cpu_seconds(CLOCK_THREAD_CPUTIME_ID);
      std::string result = answer(request);
      StageTimes& stage = recorded.stages[stage_of(request)];
      stage.seconds.push_back(cpu_seconds(CLOCK_THREAD_CPUTIME_ID) - begin);
      stage.bytes += static_cast<double>(result.size());
      return recorded.results[std::string(request)] = result;
    });
    lead(crew, 0);
  }
  std::map<std::uint64_t, std::pair<double, double>> spans;  // of the first and the last request of a stage
  Crew crew(alone, {.threads = 1}, [&](std::string_view request) {
    const double now = cpu_seconds(CLOCK_PROCESS_CPUTIME_ID);
    spans.try_emplace(stage_of(request), now, now).first->second.second = now;
    return recorded.results.find(request)->second;
  });
  const double leading = seconds_of([&] { lead(crew, 1); });
  Measured found;
  found.alone = leading;
  for (const auto& [stage, times] : recorded.stages) {
    const auto count = times.seconds.size();
    const double handled = spans[stage].second - spans[stage].first;
    found.alone -= handled;
    found.stages.push_back(
        {.requests = times.seconds,
         .bytes = times.bytes / static_cast<double>(count),
         .handling = handled / static_cast<double>(std::max<std::size_t>(count - 1, 1)) + 2 * a_message,
         .seconds_a_byte = a_byte,
         .count = count});
  }
  return found;
}

void show(const std::vector<MeasuredWork>& works) {
  std::cout << "stage  requests     mean ms      max ms  bytes/result  rank 0 us/result\n";
  for (std::size_t i = 0; i < works.size(); ++i) {
    const MeasuredWork& w = works[i];
    const double sum = std::accumulate(w.requests.begin(), w.requests.end(), 0.0);
    std::cout << fmt::format("{:5}  {:8}  {:10.3f}  {:10.3f}  {:12.0f}  {:16.1f}\n", i + 1, w.count,
                             1e3 * sum / static_cast<double>(w.requests.size()),
                             1e3 * *std::max_element(w.requests.begin(), w.requests.end()), w.bytes, 1e6 * w.handling);
  }
}

/// So many times the work, in no more requests of a stage than there would be: they are longer instead.
std::vector<MeasuredWork> grown(std::vector<MeasuredWork> works, std::uint64_t times, std::uint64_t most_requests) {
  for (MeasuredWork& work : works) {
    work.count *= times;
    if (work.count <= most_requests) continue;
    for (double& seconds : work.requests)
      seconds *= static_cast<double>(work.count) / static_cast<double>(most_requests);
    work.count = most_requests;
  }
  return works;
}

/// All stages, one after the other.
void show_predicted(const std::vector<MeasuredWork>& works, double alone) {
  const auto run_of = [&](std::uint64_t cores) {
    PredictedRun total{.seconds = alone, .bottleneck = Bottleneck::alone};
    double longest = alone;
    for (const MeasuredWork& work : works) {
      const PredictedRun run = predict(work, cores);
      total.seconds += run.seconds;
      if (run.seconds > longest) total.bottleneck = run.bottleneck;
      longest = std::max(longest, run.seconds);
    }
    return total;
  };
  const double one = run_of(1).seconds;
  std::cout << " cores     seconds  efficiency  bounded by\n";
  for (const std::uint64_t cores : {1U, 2U, 10U, 100U, 1'000U, 10'000U}) {
    const PredictedRun run = run_of(cores);
    std::cout << fmt::format("{:6}  {:10.2f}  {:9.1f}%  {}\n", cores, run.seconds,
                             100 * one / (run.seconds * static_cast<double>(cores)), name(run.bottleneck));
  }
}

constexpr std::uint64_t larger = 1000, any_number = std::uint64_t{1} << 60U;

int scale_verify(const std::string& claims, std::uint64_t samples) {
  const ClaimsFile file = read_claims(claims);
  VerifyOptions options;
  options.samples = samples;
  const auto checked_anew = [&] {
    options.certificates = std::make_shared<Certificates>(std::filesystem::path(claims).parent_path());
    return std::make_unique<Verification>(file, options);
  };
  std::vector<std::unique_ptr<Verification>> runs(2);
  double alone = seconds_of([&] { runs[0] = checked_anew(); });
  runs[1] = checked_anew();
  VerifyResult result;
  const auto [works, between] = measured([&](std::string_view request) { return runs[0]->answer(request); },
                                         [&](Crew& crew, std::size_t run) { result = runs[run]->result(&crew); },
                                         [](std::string_view request) {
                                           ByteReader bytes(request);
                                           bytes.number();
                                           return bytes.number();
                                         });
  alone += between;
  show(works);
  std::cout << fmt::format("rank 0 alone: {:.2f} s\n\n", alone);
  show_predicted(works, alone);
  std::cout << fmt::format("\n{} times the samples and lines, in pieces of 32 samples\n", larger);
  std::vector<MeasuredWork> small = grown(works, larger, any_number), usual = works;
  for (std::size_t i = works.size() - 2; i < works.size(); ++i)
    small[i] = works[i];  // claims and certificates: no more
  show_predicted(small, alone);
  std::cout << fmt::format("\n{} times the samples and lines, in at most 16384 pieces\n", larger);
  usual.front() = grown({works.front()}, larger, 16'384).front();
  if (usual.size() == 4) usual[1] = grown({works[1]}, larger, any_number).front();
  show_predicted(usual, alone);
  return 0;
}

/// With a prefix in parts, which are written in the time of a request.
int scale_certify(const std::string& file, const std::string& scene, const std::string& prefix) {
  CertifyOptions options;
  options.file = file;
  options.mechanism = bicycle_records(read_scene(scene));
  const RecordPieces pieces(options);
  PartWriter part(prefix, 0);
  const auto [works, between] =
      measured([&](std::string_view request) { return pieces.answer(request, prefix.empty() ? nullptr : &part); },
               [&](Crew& crew, std::size_t) { pieces.certify(crew, [](std::string_view) {}); },
               [](std::string_view request) { return ByteReader(request).number(); });
  show(works);
  std::cout << fmt::format("rank 0 alone: {:.2f} s\n\n{} times as many records\n", between, larger);
  show_predicted(grown(works, larger, any_number), between);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv, argv + argc);
  if (argc == 4 && arguments[1] == "verify") return scale_verify(arguments[2], std::stoull(arguments[3]));
  if ((argc == 4 || argc == 5) && arguments[1] == "certify") {
    return scale_certify(arguments[2], arguments[3], argc == 5 ? arguments[4] : "");
  }
  std::cerr << "usage: scale verify CLAIMS SAMPLES | scale certify FILE SCENE [PREFIX]\n";
  return 2;
}
