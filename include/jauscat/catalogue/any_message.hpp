// A message whose type is known at run time only, with its values.
#pragma once
#include <jauscat/catalogue/entry.hpp>
#include <jauscat/schema/jaus/command_code.hpp>
#include <jauscat/text/describe.hpp>
#include <jauscat/wire/arena.hpp>

#include <memory>

namespace jauscat::catalogue {

/// A message with its values. It owns all that they consist of.
class any_message {
  public:
    /// That of a result without a value. Only assignment and destruction are defined.
    any_message() = default;
    explicit any_message(const entry& type) : object_{type.data_->make(), type.data_->destroy}, data_{type.data_} {}

    [[nodiscard]] entry type() const noexcept { return entry{*data_}; }
    [[nodiscard]] std::uint16_t command_code() const noexcept { return data_->command_code; }
    /// The object of the message's type.
    [[nodiscard]] const void* object() const noexcept { return object_.get(); }
    /// The message, if it is a `T`; else nullptr.
    template <wire::message T> [[nodiscard]] const T* as() const {
        return data_->fields().id == text::describe<T>().id ? static_cast<const T*>(object_.get()) : nullptr;
    }

    /// The body. Errors: those of wire::encode.
    [[nodiscard]] result<std::vector<std::byte>, wire::errc> encode() const {
        if (const wire::errc error = data_->check_values(object_.get()); error != wire::errc::ok) return error;
        return encode(wire::tolerate_values);
    }
    /// The same, and accepts values outside their value sets.
    [[nodiscard]] result<std::vector<std::byte>, wire::errc> encode(wire::tolerate_values_tag) const {
        return data_->encode(object_.get());
    }
    /// The fields with values outside their value sets: `object[2].type`.
    [[nodiscard]] JAUSCAT_FUNCTION std::vector<std::string> outside_values() const;
    /// The fields, a line each; `indent` spaces before them.
    [[nodiscard]] JAUSCAT_FUNCTION std::string to_text(std::size_t indent = 2) const;

    /// A message that `fill(void* object, wire::arena&)` makes, which returns a result. Where that is `arena_full`, it
    /// is called again with more memory, up to a limit.
    template <class Fill> [[nodiscard]] static auto made_by(const entry& type, std::size_t memory, Fill&& fill) {
        constexpr std::size_t most = std::size_t{1} << 28U; // bytes: no message needs as much
        using filled_type = decltype(fill(static_cast<void*>(nullptr), std::declval<wire::arena&>()));
        using error = typename filled_type::error_type;
        for (;; memory *= 2) {
            any_message made{type};
            made.lists_.resize(memory);
            wire::arena arena{made.lists_};
            const auto filled = fill(made.object_.get(), arena);
            if (filled) return result<any_message, error>{std::move(made)};
            if (!is_arena_full(filled.error()) || memory == 0 || memory > most / 2)
                return result<any_message, error>{filled.error()};
        }
    }

  private:
    friend class entry;
    static bool is_arena_full(const text::error& why) { return why.code == text::errc::arena_full; }
    static bool is_arena_full(wire::errc why) { return why == wire::errc::arena_full; }

    static void nothing(void*) {}
    std::vector<std::byte> bytes_{}, lists_{}; ///< what the object's bytes and lists are in
    std::unique_ptr<void, void (*)(void*)> object_{nullptr, &nothing};
    const detail::entry_data* data_{};
};

} // namespace jauscat::catalogue

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/catalogue/impl/entry.ipp>
#endif
