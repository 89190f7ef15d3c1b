// SPDX-License-Identifier: BSD-3-Clause
#include "support/fcl_boxes.hpp"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>

#include <algorithm>

namespace contactsim::test {

namespace {

using Object = fcl::CollisionObject<double>;

/// A shape of which FCL knows nothing but its box.
class AnyShape final : public fcl::CollisionGeometry<double> {
 public:
  explicit AnyShape(const contactsim::Box& box) { set(box); }
  void computeLocalAABB() override {}
  void set(const contactsim::Box& box) {
    aabb_local = fcl::AABB<double>(fcl::Vector3d(box.lo[0], box.lo[1], box.lo[2]),
                                   fcl::Vector3d(box.hi[0], box.hi[1], box.hi[2]));
  }
};

std::uint32_t number_of(const Object* object) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(object->getUserData()));
}

void add(std::uint32_t row, std::uint32_t partner, void* pairs) {
  static_cast<std::vector<RowPartner>*>(pairs)->push_back({row, partner});
}

bool add_pair(Object* row, Object* partner, void* pairs) {
  add(number_of(row), number_of(partner), pairs);
  return false;
}

/// A query hands over what it found before what it asked for.
bool add_answer(Object* partner, Object* row, void* pairs) {
  add(number_of(row), number_of(partner), pairs);
  return false;
}

bool add_self_pair(Object* a, Object* b, void* pairs) {
  add(std::min(number_of(a), number_of(b)), std::max(number_of(a), number_of(b)), pairs);
  return false;
}

}  // namespace

struct FclBoxes::Objects {
  std::vector<std::shared_ptr<AnyShape>> shapes;
  std::vector<std::unique_ptr<Object>> objects;
  fcl::DynamicAABBTreeCollisionManager<double> tree;
};

FclBoxes::FclBoxes(std::span<const contactsim::Box> boxes) : objects_(std::make_unique<Objects>()) {
  std::vector<Object*> all;
  for (std::uintptr_t i = 0; i < boxes.size(); ++i) {
    objects_->shapes.push_back(std::make_shared<AnyShape>(boxes[i]));
    objects_->objects.push_back(std::make_unique<Object>(objects_->shapes.back()));
    all.push_back(objects_->objects.back().get());
    all.back()->setUserData(reinterpret_cast<void*>(i));
  }
  objects_->tree.registerObjects(all);
  objects_->tree.setup();
}

FclBoxes::~FclBoxes() = default;

void FclBoxes::move(std::span<const contactsim::Box> boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    objects_->shapes[i]->set(boxes[i]);
    objects_->objects[i]->computeAABB();
  }
}

void FclBoxes::update(std::span<const contactsim::Box> boxes) {
  move(boxes);
  objects_->tree.update();
}

void FclBoxes::collide(const FclBoxes& partners, std::vector<RowPartner>& pairs) const {
  objects_->tree.collide(&partners.objects_->tree, &pairs, add_pair);
}

void FclBoxes::collide_one_by_one(const FclBoxes& partners, std::vector<RowPartner>& pairs) const {
  for (const auto& object : objects_->objects)
    partners.objects_->tree.collide(object.get(), &pairs, add_answer);
}

void FclBoxes::collide_self(std::vector<RowPartner>& pairs) const {
  objects_->tree.collide(&pairs, add_self_pair);
}

}  // namespace contactsim::test
