// Error codes that name their subject: a category for each text.
#pragma once
#include <jauscat/app/detail/explained.hpp>

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

/// A category whose errors have one text.
class explained_category final : public boost::system::error_category {
  public:
    explained_category(const known_category& of, std::string text)
        : error_category{of.number()}, of_{of}, text_{std::move(text)} {}
    [[nodiscard]] const char* name() const noexcept override { return of_.name(); }
    [[nodiscard]] std::string message(int) const override { return text_; }

  private:
    const known_category& of_;
    std::string text_;
};

JAUSCAT_DECL boost::system::error_code explained(const boost::system::error_code& error, const std::string& text) {
    constexpr std::size_t most = 4096;
    static std::mutex mutex;
    static std::map<std::pair<const known_category*, std::string>, std::unique_ptr<explained_category>> all;

    const auto* const category = dynamic_cast<const known_category*>(&error.category());
    if (category == nullptr) return error;
    const std::scoped_lock lock{mutex};
    const std::pair key{category, text};
    auto found = all.find(key);
    if (found == all.end()) {
        if (all.size() >= most) return error;
        found = all.emplace(key, std::make_unique<explained_category>(*category, text)).first;
    }
    return {error.value(), *found->second};
}

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
