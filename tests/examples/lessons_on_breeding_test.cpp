// SPDX-License-Identifier: MIT
// Every number of the lesson about breeding is bred, learned and searched for again here, as
// examples/lessons/make does.
#include <algorithm>
#include <catch_amalgamated.hpp>
#include <vector>

#include "core/breeding/litter.h"
#include "core/breeding/motion_traits.h"
#include "core/breeding/taste_weights.h"
#include "tests/lesson.h"
#include "tests/litter.h"

namespace gaitsmith::test {

namespace {

/// A judge of the lesson: of nine children, the two that turn over most are the parents of the next.
class Breeder {
 public:
  explicit Breeder(Document first) : first_(std::move(first)), parents_(first_.controllers) {}

  /// @return the child that turns over most
  Document NextGeneration() {
    BreedRound wish;
    wish.seed = ++generation_;
    wish.difference = 0.5f;
    wish.task = first_.task;
    const Document nursery = NurseryOf(first_, parents_, wish);
    std::vector<Document> children;
    for (const Brood::Member& child : ChildrenOf(nursery)) children.push_back(ChildOf(nursery, child.genome));
    std::ranges::sort(children, std::greater(),
                      [](const Document& child) { return TermsOf(child).rotations; });
    parents_ = {children[0].controllers[0], children[1].controllers[0]};
    for (std::size_t picked = 0; picked < 2; ++picked) {
      for (std::size_t left = 2; left < children.size(); ++left)
        comparisons_.push_back(
            {*MotionTraits(children[picked]), *MotionTraits(children[left]), Verdict::kFirst});
    }
    return children[0];
  }

  /// The lesson's search for what the picks so far have in common.
  [[nodiscard]] Found Liked() const {
    Document wished = first_;
    wished.task.weights = WeightsOf(Taste(comparisons_), first_);
    return FindWith(wished, Algorithm::kPoseCycle, 1, 6000);
  }

 private:
  Document first_;
  std::vector<Controller> parents_;
  std::vector<Comparison> comparisons_;
  std::uint32_t generation_ = 0;
};

}  // namespace

TEST_CASE("lessons: you are the judge", "[lessons]") {
  const Lesson lesson = LessonOf("8-the-judge");
  const std::string& goal = lesson.fields.at("goal");
  const Document frog = Shipped("lessons/8-hop");
  Says(lesson, "This frog gets 31.3 m in 8 s, and it never turns over.");
  CHECK(frog.duration_steps == 800);
  Says(lesson, "| the frog | 0.0 | 31.3 m |");
  CHECK(Rounded(TermsOf(frog).rotations, 1) == 0.0);
  CHECK(Rounded(TermsOf(frog).travel_m, 1) == 31.3);

  Breeder breeder(frog);
  const Terms first = TermsOf(breeder.NextGeneration());
  Says(lesson, "| 1 | 0.5 | 6.6 m |");
  CHECK(Rounded(first.rotations, 1) == 0.5);
  CHECK(Rounded(first.travel_m, 1) == 6.6);
  Says(lesson, "our two picks had turned over halfway, and then lay on their backs");
  CHECK(first.upright < -0.8f);
  const Document misjudged = Shipped("lessons/8-misjudged");
  CHECK(breeder.Liked().outcome.best == misjudged.controllers[0].genes);
  Says(lesson, "a frog that runs on its back");
  Says(lesson, "32.7 m, and 0.4 turns");
  CHECK(TermsOf(misjudged).upright < -0.8f);
  CHECK(Rounded(TermsOf(misjudged).travel_m, 1) == 32.7);
  CHECK(Rounded(TermsOf(misjudged).rotations, 1) == 0.4);

  const Terms second = TermsOf(breeder.NextGeneration());
  Says(lesson, "| 2 | 7.5 | 11.8 m |");
  CHECK(Rounded(second.rotations, 1) == 7.5);
  CHECK(Rounded(second.travel_m, 1) == 11.8);

  const Document third = breeder.NextGeneration(), picked = Shipped("lessons/8-picked");
  Says(lesson, "19.6 m |");
  CHECK(third.controllers[0].genes == picked.controllers[0].genes);
  CHECK(Rounded(TermsOf(picked).rotations, 1) == 7.6);
  CHECK(Rounded(TermsOf(picked).travel_m, 1) == 19.6);
  CHECK(Reaches(goal, picked));
  const Document liked = Shipped("lessons/8-liked");
  CHECK(breeder.Liked().outcome.best == liked.controllers[0].genes);
  Says(lesson, "16.5 turns, 3.2 m high, 24.9 m far");
  Says(lesson, "the frog that turns over 16.5 times?");
  CHECK(Rounded(TermsOf(liked).rotations, 1) == 16.5);
  CHECK(Rounded(TermsOf(liked).max_cm_height_m, 1) == 3.2);
  CHECK(Rounded(TermsOf(liked).travel_m, 1) == 24.9);
}

}  // namespace gaitsmith::test
