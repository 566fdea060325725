#include "puadem/base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <mutex>
#include <thread>
#include <utility>

namespace puadem {

namespace {

std::atomic<int> thread_count = 0;

int threads_of_machine() {
  const char* wanted = std::getenv("OMP_NUM_THREADS");  // what batch systems set
  const int given = wanted != nullptr ? std::atoi(wanted) : 0;
  return given > 0 ? given : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// A share of the blocks. Its owner takes them from the front, so that the same thread meets the same data in
/// every loop; whoever is done early helps the others from the back.
struct alignas(64) Share {
  std::atomic<std::uint64_t> range = 0;  ///< first block left, and the end of them in the upper half
};

constexpr std::uint64_t range_of(int begin, int end) {
  return static_cast<std::uint64_t>(end) << 32 | static_cast<std::uint64_t>(begin);
}

/// The next block, or -1 where none is left.
int take_block(Share& share, bool from_front) {
  std::uint64_t range = share.range;
  for (;;) {
    const int begin = static_cast<int>(range & 0xffffffff), end = static_cast<int>(range >> 32);
    if (begin >= end) return -1;
    const std::uint64_t rest = from_front ? range_of(begin + 1, end) : range_of(begin, end - 1);
    if (share.range.compare_exchange_weak(range, rest)) return from_front ? begin : end - 1;
  }
}

/// The threads beside the caller, and the loop they are at. A helper that wakes up late finds the loop closed:
/// nobody waits for a thread that has taken no block.
struct Team {
  std::vector<std::thread> helper;
  std::vector<Share> share;
  void (*body)(void*, int) = nullptr;
  void* context = nullptr;
  std::atomic<bool> stops = false;
  std::atomic<bool> open = false;           ///< are there blocks to take?
  alignas(64) std::atomic<int> round = 0;   ///< counts the loops given out
  alignas(64) std::atomic<int> inside = 0;  ///< helpers that may hold a block
  std::mutex fault;                         ///< guards the next two
  std::exception_ptr first;
  int first_block = 0;
};

thread_local bool in_loop = false;

/// Waits until `value` differs from `old`: a moment awake, for loops follow each other closely, then asleep,
/// for a thread that spins takes the core from whom it waits for.
void wait_while(const std::atomic<int>& value, int old) {
  constexpr int looks = 1500;  // some 20 to 50 microseconds
  for (int look = 0; look < looks; ++look) {
    if (value.load(std::memory_order_acquire) != old) return;
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
  }
  value.wait(old, std::memory_order_acquire);
}

void take_part(Team& team, int member) {
  const int members = size_of(team.share);
  for (int m = 0; m < members; ++m) {
    Share& share = team.share[to_size((member + m) % members)];
    for (int block = take_block(share, m == 0); block >= 0; block = take_block(share, m == 0)) {
      try {
        team.body(team.context, block);
      } catch (...) {
        const std::lock_guard lock(team.fault);
        if (!team.first || block < team.first_block) {
          team.first_block = block;
          team.first = std::current_exception();
        }
      }
    }
  }
}

void help(Team& team, int member) {
  in_loop = true;
  for (int round = 0;;) {
    wait_while(team.round, round);
    round = team.round;
    if (team.stops) return;
    ++team.inside;
    if (team.open) take_part(team, member);
    if (--team.inside == 0) team.inside.notify_one();
  }
}

void call(Team& team) {
  ++team.round;
  team.round.notify_all();
}

void dismiss(Team& team) {
  team.stops = true;
  call(team);
  for (std::thread& helper : team.helper) helper.join();
  team.helper.clear();
}

void hire(Team& team, int members) {
  dismiss(team);
  team.stops = false;
  team.round = 0;
  team.share = std::vector<Share>(to_size(members));
  for (int member = 1; member < members; ++member) team.helper.emplace_back([&team, member] { help(team, member); });
}

struct StandingTeam : Team {
  ~StandingTeam() { dismiss(*this); }
};

}  // namespace

void set_threads(int threads) {
  assert(threads >= 0);
  thread_count = threads;
}

int threads() {
  static const int of_machine = threads_of_machine();
  return thread_count > 0 ? thread_count.load() : of_machine;
}

void detail::run_blocks(int blocks, void (*body)(void*, int), void* context) {
  static std::mutex in_use;
  std::unique_lock lock(in_use, std::defer_lock);
  if (in_loop || !lock.try_lock()) {  // a loop within a loop, or a second caller
    for (int block = 0; block < blocks; ++block) body(context, block);
    return;
  }
  static StandingTeam team;
  const int members = threads();
  if (size_of(team.share) != members) hire(team, members);
  team.body = body;
  team.context = context;
  team.first = nullptr;
  for (int m = 0; m < members; ++m) {
    const auto bound = [&](int member) { return static_cast<int>(static_cast<long>(blocks) * member / members); };
    team.share[to_size(m)].range = range_of(bound(m), bound(m + 1));
  }
  team.open = true;
  call(team);
  in_loop = true;
  take_part(team, 0);
  in_loop = false;
  team.open = false;
  for (int inside = team.inside; inside > 0; inside = team.inside) wait_while(team.inside, inside);
  if (team.first) std::rethrow_exception(std::exchange(team.first, nullptr));
}

}  // namespace puadem
