// The category of node_errc.
#pragma once
#include <jauscat/app/detail/explained.hpp>
#include <jauscat/app/error.hpp>

#include <string>

namespace jauscat {
inline namespace JAUSCAT_WAY {

JAUSCAT_DECL const boost::system::error_category& node_category() noexcept {
    static const class category_type final : public app::known_category {
      public:
        category_type() : known_category{0x6A61757363617400} {}
        [[nodiscard]] const char* name() const noexcept override { return "jauscat.node"; }
        [[nodiscard]] std::string message(int code) const override {
            return std::string{describe(static_cast<node_errc>(code))};
        }
    } category;
    return category;
}

} // namespace JAUSCAT_WAY
} // namespace jauscat
