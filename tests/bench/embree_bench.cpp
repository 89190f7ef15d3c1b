// SPDX-License-Identifier: BSD-3-Clause
// The search of two spheres, one turning in the other (see search_scene.hpp), by the trees of contact and by
// Embree 3: after every turn both sides are refitted and all pairs of boxes that overlap are listed. Both
// take turns in one process on one thread, and must find the same pairs.
//   contactsim_embree_bench [--rounds N] [FACES...]
#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <omp.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string_view>
#include <vector>

#include "contact/search/broad_phase.hpp"
#include "machine_limits.hpp"
#include "search_scene.hpp"

namespace contactsim::bench {

namespace {

/// Boxes in single precision, exactly, as they are in Embree's form.
class EmbreeBoxes {
 public:
  ///   quality  of the tree: how it is built, or RTC_BUILD_QUALITY_REFIT
  EmbreeBoxes(RTCDevice device, std::span<const Box> boxes, RTCBuildQuality quality)
      : scene_(rtcNewScene(device)),
        geometry_(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER)),
        bounds_(boxes.size()) {
    place(boxes);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_LOW);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_DYNAMIC);
    rtcSetGeometryBuildQuality(geometry_, quality);
    rtcSetGeometryUserPrimitiveCount(geometry_, static_cast<unsigned>(boxes.size()));
    rtcSetGeometryUserData(geometry_, bounds_.data());
    rtcSetGeometryBoundsFunction(geometry_, bounds, nullptr);
    rtcCommitGeometry(geometry_);
    rtcAttachGeometry(scene_, geometry_);
    rtcCommitScene(scene_);
  }
  ~EmbreeBoxes() {
    rtcReleaseGeometry(geometry_);
    rtcReleaseScene(scene_);
  }
  EmbreeBoxes(const EmbreeBoxes&) = delete;
  EmbreeBoxes& operator=(const EmbreeBoxes&) = delete;

  /// Where the boxes are now; the tree follows with refit().
  void place(std::span<const Box> boxes) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const auto &lo = boxes[i].lo, &hi = boxes[i].hi;
      const auto f = [](double x) { return static_cast<float>(x); };
      bounds_[i] = {f(lo[0]), f(lo[1]), f(lo[2]), 0.0F, f(hi[0]), f(hi[1]), f(hi[2]), 0.0F};
    }
  }
  void refit() {
    rtcCommitGeometry(geometry_);
    rtcCommitScene(scene_);
  }
  RTCScene scene() const { return scene_; }
  const RTCBounds& operator[](std::size_t i) const { return bounds_[i]; }

 private:
  static void bounds(const RTCBoundsFunctionArguments* arguments) {
    *arguments->bounds_o = static_cast<const RTCBounds*>(arguments->geometryUserPtr)[arguments->primID];
  }

  RTCScene scene_;
  RTCGeometry geometry_;
  std::vector<RTCBounds> bounds_;
};

/// Whether two boxes share a point.
bool do_overlap(const RTCBounds& a, const RTCBounds& b) {
  const auto corner = [](const float& first) {
    NodeSide lanes;
    std::memcpy(&lanes, &first, sizeof lanes);
    return lanes;
  };
  const auto apart = (corner(a.lower_x) > corner(b.upper_x)) | (corner(b.lower_x) > corner(a.upper_x));
  return (apart[0] | apart[1] | apart[2]) == 0;
}

/// Where collisions go: Embree reports all pairs of two leaves that meet, several boxes each unless the tree
/// is of low quality, and leaves it to the program to look at them.
struct CollisionList {
  const EmbreeBoxes &nodes, &faces;
  std::vector<RowPartner> pairs;
};

void list_collisions(void* place, RTCCollision* collisions, unsigned n) {
  auto& list = *static_cast<CollisionList*>(place);
  for (unsigned i = 0; i < n; ++i) {
    const RowPartner pair{collisions[i].primID0, collisions[i].primID1};
    if (do_overlap(list.nodes[pair.row], list.faces[pair.partner])) list.pairs.push_back(pair);
  }
}

/// Number of pairs and a sum over them that does not depend on their order.
struct PairDigest {
  std::uint64_t n = 0, sum = 0;

  void add(std::uint64_t row, std::uint64_t partner) {
    std::uint64_t x = row << 32 | partner;  // Steele, Lea and Flood (2014), SplitMix64
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    sum += x ^ (x >> 31);
    ++n;
  }
  bool operator==(const PairDigest&) const = default;
};

PairDigest digest_of(const PairTable& table) {
  PairDigest digest;
  for (std::size_t row = 0; row < table.n_rows(); ++row) {
    for (const std::uint32_t partner : table.of(row)) digest.add(row, partner);
  }
  return digest;
}

PairDigest digest_of(std::span<const RowPartner> pairs) {
  PairDigest digest;
  for (const RowPartner& pair : pairs) digest.add(pair.row, pair.partner);
  return digest;
}

/// Least seconds of the two halves of a search and of both together.
struct SearchTimes {
  double refit = std::numeric_limits<double>::infinity(), find = refit, both = refit;

  template <class Refit, class Find>
  void time(const Refit& do_refit, const Find& do_find) {
    const double begin = thread_seconds();
    do_refit();
    const double middle = thread_seconds();
    do_find();
    const double end = thread_seconds();
    refit = std::min(refit, middle - begin);
    find = std::min(find, end - middle);
    both = std::min(both, end - begin);
  }
  void print(std::string_view name, double n) const {
    fmt::print(" {0}_refit {1:.4g} {0}_find {2:.4g} {0} {3:.4g}", name, 1e9 * refit / n, 1e9 * find / n,
               1e9 * both / n);
  }
};

/// Contact's own trees.
struct OwnSearch {
  BroadPhase nodes, faces;
  PairTable lists;
  SearchTimes times;

  void search(const SearchScene& scene) {
    times.time(
        [&] {
          if (nodes.update(scene.nodes()) || faces.update(scene.faces())) std::abort();
        },
        [&] {
          nodes.find_pairs(
              faces, [](std::uint32_t, std::uint32_t) { return true; }, lists);
        });
  }
};

/// Embree's. Trees that are to be refitted it builds carefully, once; those of low quality it builds anew
/// every time.
struct EmbreeSearch {
  EmbreeSearch(RTCDevice device, const SearchScene& scene, RTCBuildQuality quality)
      : nodes(device, scene.nodes(), quality), faces(device, scene.faces(), quality) {}

  void search(const SearchScene& scene) {
    nodes.place(scene.nodes());
    faces.place(scene.faces());
    list.pairs.clear();
    times.time(
        [&] {
          nodes.refit();
          faces.refit();
        },
        [&] { rtcCollide(nodes.scene(), faces.scene(), list_collisions, &list); });
  }

  EmbreeBoxes nodes, faces;
  CollisionList list{nodes, faces, {}};
  SearchTimes times;
};

/// Prints nanoseconds per face. Returns whether all agree.
bool compare(RTCDevice device, std::int64_t n_faces, int n_rounds) {
  SearchScene scene(n_faces);
  OwnSearch own;
  EmbreeSearch refitted(device, scene, RTC_BUILD_QUALITY_REFIT),
      rebuilt(device, scene, RTC_BUILD_QUALITY_LOW);
  bool agree = true;
  PairDigest digest;
  for (int round = 0; round < n_rounds; ++round) {
    scene.move();
    own.search(scene);
    refitted.search(scene);
    rebuilt.search(scene);
    digest = digest_of(own.lists);
    agree = agree && digest == digest_of(refitted.list.pairs) && digest == digest_of(rebuilt.list.pairs);
  }
  const auto n = static_cast<double>(scene.faces().size());
  fmt::print("search faces {} pairs {} hash {} agree {}", n, digest.n, digest.sum, agree ? 1 : 0);
  own.times.print("contactsim", n);
  refitted.times.print("embree_refit", n);
  rebuilt.times.print("embree_rebuild", n);
  fmt::print("\n");
  std::fflush(stdout);
  return agree;
}

int run(int n, char** words) {
  omp_set_num_threads(1);
  int n_rounds = 20;
  std::vector<std::int64_t> sizes;
  for (int i = 1; i < n; ++i) {
    if (std::string_view(words[i]) == "--rounds" && i + 1 < n) {
      n_rounds = std::atoi(words[++i]);
    } else {
      sizes.push_back(std::atoll(words[i]));
    }
  }
  if (sizes.empty()) sizes = {10'000, 100'000, 1'000'000};
  const RTCDevice device = rtcNewDevice("threads=1,set_affinity=0");
  bool agree = true;
  for (const std::int64_t n_faces : sizes) agree = compare(device, n_faces, n_rounds) && agree;
  rtcReleaseDevice(device);
  return agree ? 0 : 1;
}

}  // namespace

}  // namespace contactsim::bench

int main(int n, char** words) { return contactsim::bench::run(n, words); }
