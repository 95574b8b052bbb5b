// The categories of the errors of a bus.
#pragma once
#include <jauscat/app/bus_error.hpp>
#include <jauscat/app/detail/explained.hpp>
#include <jauscat/app/impl/numbered.hpp>
#include <jauscat/ethercat/code_texts.hpp>

#include <string>

namespace jauscat {
inline namespace JAUSCAT_WAY {

JAUSCAT_DECL const boost::system::error_category& bus_category() noexcept {
    static const class category_type final : public app::known_category {
      public:
        category_type() : known_category{0x6A61757363617401} {}
        [[nodiscard]] const char* name() const noexcept override { return "jauscat.bus"; }
        [[nodiscard]] std::string message(int code) const override {
            return std::string{describe(static_cast<bus_errc>(code))};
        }
    } category;
    return category;
}

JAUSCAT_DECL const boost::system::error_category& abort_category() noexcept {
    static const class category_type final : public app::known_category {
      public:
        category_type() : known_category{0x6A61757363617402} {}
        [[nodiscard]] const char* name() const noexcept override { return "jauscat.abort"; }
        [[nodiscard]] std::string message(int code) const override {
            return app::numbered("abort code %08Xh: ", code) +
                   std::string{ethercat::describe(static_cast<ethercat::abort_code>(code))};
        }
    } category;
    return category;
}

JAUSCAT_DECL const boost::system::error_category& al_status_category() noexcept {
    static const class category_type final : public app::known_category {
      public:
        category_type() : known_category{0x6A61757363617403} {}
        [[nodiscard]] const char* name() const noexcept override { return "jauscat.al_status"; }
        [[nodiscard]] std::string message(int code) const override {
            return app::numbered("AL status code %04Xh: ", code) +
                   std::string{ethercat::describe(static_cast<ethercat::al_status_code>(code))};
        }
    } category;
    return category;
}

JAUSCAT_DECL const boost::system::error_category& axis_category() noexcept {
    static const class category_type final : public app::known_category {
      public:
        category_type() : known_category{0x6A61757363617404} {}
        [[nodiscard]] const char* name() const noexcept override { return "jauscat.axis"; }
        [[nodiscard]] std::string message(int code) const override {
            return std::string{describe(static_cast<cia402::axis_errc>(code))};
        }
    } category;
    return category;
}

} // namespace JAUSCAT_WAY
} // namespace jauscat
