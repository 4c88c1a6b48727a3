#include "claims/meaning/random/shrink.hpp"

namespace slipproof::meaning {

namespace {

bool is_condition(const Tree& tree) {
  return tree->op == Op::truth || tree->op == Op::chain || tree->op == Op::negation || tree->op == Op::conjunction ||
         tree->op == Op::disjunction;
}

bool is_equation(const Tree& tree) {
  return tree->relations == std::vector<std::string>{"="};
}

/// Of the same sort, each with a part less, or as simple as can be.
std::vector<Tree> smaller(const Tree& tree) {
  std::vector<Tree> result;
  if (tree->parts.empty()) return result;
  if (is_condition(tree)) result = {truth(true), truth(false)};
  if (!is_condition(tree)) result = {number(0), number(1)};
  for (std::size_t i = 0; i < tree->parts.size(); ++i) {
    if (is_condition(tree->parts[i]) == is_condition(tree)) result.push_back(tree->parts[i]);
    for (const Tree& part : smaller(tree->parts[i])) {
      Node node = *tree;
      node.parts[i] = part;
      result.push_back(std::make_shared<const Node>(std::move(node)));
    }
  }
  return result;
}

void remove_reference(std::vector<std::size_t>& claims, std::size_t removed) {
  std::erase(claims, removed);
  for (std::size_t& i : claims) i -= i > removed ? 1 : 0;
}

File without_claim(File file, std::size_t removed) {
  file.claims.erase(file.claims.begin() + static_cast<std::ptrdiff_t>(removed));
  for (Claim& claim : file.claims) {
    for (auto* references : {&claim.claims, &claim.except, &claim.given}) remove_reference(*references, removed);
  }
  return file;
}

class Shrinker {
 public:
  Shrinker(File file, std::size_t claim, const Shows& shows) : file_(std::move(file)), claim_(claim), shows_(shows) {}

  void run() {
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t i = file_.claims.size(); i-- > 0;) changed = try_without(i) || changed;
      for (Tree* tree : trees()) changed = try_smaller(*tree) || changed;
    }
  }
  File file_;
  std::size_t claim_;

 private:
  bool try_without(std::size_t i) {
    if (i == claim_) return false;
    File file = without_claim(file_, i);
    const std::size_t claim = claim_ - (i < claim_ ? 1 : 0);
    if (!shows_(file, claim)) return false;
    file_ = std::move(file);
    claim_ = claim;
    return true;
  }

  std::vector<Tree*> trees() {
    std::vector<Tree*> result = {&file_.setting.force_domain};
    for (Parameter& parameter : file_.setting.parameters) result.push_back(&parameter.domain);
    for (auto& [symbol, value] : file_.setting.scene) result.push_back(&value);
    for (auto& [symbol, value] : file_.setting.definitions) result.push_back(&value);
    if (file_.setting.mechanics) {
      for (auto& [symbol, value] : file_.setting.mechanics->definitions) result.push_back(&value);
      for (Tree* tree : file_.setting.mechanics->coefficients()) result.push_back(tree);
    }
    for (Claim& claim : file_.claims) {
      result.insert(result.end(), {&claim.region, &claim.forces, &claim.holds});
      for (Tree& equation : claim.equations) result.push_back(&equation);
      for (Tree& equation : claim.assume) result.push_back(&equation);
    }
    std::erase_if(result, [](const Tree* tree) { return !*tree; });
    return result;
  }

  bool try_smaller(Tree& tree) {
    const Tree before = tree;
    for (const Tree& other : smaller(before)) {
      if (is_equation(before) && !is_equation(other)) continue;  // `equations` hold nothing else
      tree = other;
      if (shows_(file_, claim_)) return true;
    }
    tree = before;
    return false;
  }

  const Shows& shows_;
};

}  // namespace

std::pair<File, std::size_t> shrunk(File file, std::size_t claim, const Shows& shows) {
  Shrinker shrinker(std::move(file), claim, shows);
  shrinker.run();
  return {std::move(shrinker.file_), shrinker.claim_};
}

}  // namespace slipproof::meaning
