// Messages that are found by command code or name at run time.
#pragma once
#include <jauscat/base/stable_sort.hpp>
#include <jauscat/catalogue/any_message.hpp>

#include <algorithm>
#include <initializer_list>

namespace jauscat::catalogue {

/// Messages by ascending command code.
class list {
  public:
    list() = default;
    /// Where two have the same code, the earlier one counts.
    explicit list(std::vector<entry> messages) : entries_{std::move(messages)} { sort(); }
    /// All messages of several lists.
    list(std::initializer_list<list> lists) {
        for (const list& one : lists) entries_.insert(entries_.end(), one.begin(), one.end());
        sort();
    }

    [[nodiscard]] std::vector<entry>::const_iterator begin() const noexcept { return entries_.begin(); }
    [[nodiscard]] std::vector<entry>::const_iterator end() const noexcept { return entries_.end(); }
    [[nodiscard]] std::size_t size() const noexcept { return entries_.size(); }

    /// nullptr: no message has the code.
    [[nodiscard]] const entry* find(std::uint16_t command_code) const noexcept {
        const auto found = std::ranges::lower_bound(entries_, command_code, {}, &entry::command_code);
        return found == entries_.end() || found->command_code() != command_code ? nullptr : &*found;
    }
    /// By the name of its type, the standard's, or the code in hex: 0405, 0405h, 0x0405. Error: unknown_message.
    [[nodiscard]] JAUSCAT_FUNCTION result<const entry*, text::error> find(std::string_view name) const;

    /// The message that a line names in its first word, with the fields of the others.
    [[nodiscard]] JAUSCAT_FUNCTION result<any_message, text::error> from_text(std::string_view line) const;

    /// Which field and byte of a body are at fault; empty where it decodes, or its code is not known.
    [[nodiscard]] JAUSCAT_FUNCTION std::string why_malformed(std::uint16_t command_code,
                                                             std::span<const std::byte> body) const;
    /// The same as a function, for `node_options::explain_malformed`. The list must outlive it.
    [[nodiscard]] auto explainer() const {
        return [this](std::uint16_t command_code, std::span<const std::byte> body) {
            return why_malformed(command_code, body);
        };
    }
    /// A line for each field of a message's header and body; the body in hex where its code is not known.
    [[nodiscard]] JAUSCAT_FUNCTION std::string annotate(std::span<const std::byte> message) const;

  private:
    void sort() {
        jauscat::stable_sort(entries_, &entry::command_code);
        const auto same = [](const entry& a, const entry& b) { return a.command_code() == b.command_code(); };
        entries_.erase(std::unique(entries_.begin(), entries_.end(), same), entries_.end());
    }

    std::vector<entry> entries_{};
};

} // namespace jauscat::catalogue

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/catalogue/impl/list.ipp>
#endif
