#pragma once
#include <jauscat/catalogue/any_message.hpp>
#include <jauscat/text/from_text.hpp>
#include <jauscat/text/outside_values.hpp>
#include <jauscat/text/print.hpp>

namespace jauscat::catalogue {

JAUSCAT_FUNCTION any_message entry::make() const { return any_message{*this}; }

JAUSCAT_FUNCTION result<any_message, wire::errc> entry::decoded(std::span<const std::byte> body,
                                                                bool tolerates_values) const {
    // Elements are larger than their bytes: doubles for scaled integers, and what is optional.
    const std::size_t memory = data_->has_lists ? 256 + 16 * body.size() : 0;
    return any_message::made_by(*this, memory,
                                [&](void* object, wire::arena& arena) -> result<std::size_t, wire::errc> {
                                    const auto done = data_->decode(object, body, arena);
                                    if (tolerates_values && done.error() == wire::errc::outside_value_set)
                                        return body.size(); // it is complete
                                    return done;
                                });
}

JAUSCAT_FUNCTION result<any_message, wire::diagnosis> entry::decode(std::span<const std::byte> body,
                                                                    bool tolerates_values) const {
    std::vector<std::byte> bytes{body.begin(), body.end()};
    auto made = decoded(bytes, tolerates_values);
    if (!made) return data_->diagnose(bytes, made.error());
    made->bytes_ = std::move(bytes); // the same memory
    return std::move(*made);
}
JAUSCAT_FUNCTION result<any_message, wire::diagnosis> entry::decode(std::span<const std::byte> body) const {
    return decode(body, false);
}
JAUSCAT_FUNCTION result<any_message, wire::diagnosis> entry::decode(std::span<const std::byte> body,
                                                                    wire::tolerate_values_tag) const {
    return decode(body, true);
}

JAUSCAT_FUNCTION wire::diagnosis entry::diagnose(std::span<const std::byte> body) const {
    return data_->diagnose(body, decoded(body, false).error());
}

JAUSCAT_FUNCTION result<any_message, text::error> entry::from_words(std::span<const std::string> words) const {
    constexpr std::size_t memory = 1024;
    return any_message::made_by(*this, memory, [&](void* object, wire::arena& arena) {
        return text::from_words(words, data_->fields(), object, arena);
    });
}

JAUSCAT_FUNCTION result<any_message, text::error> entry::from_text(std::string_view line) const {
    const auto words = text::split(line);
    if (!words) return words.error();
    return from_words(*words);
}

JAUSCAT_FUNCTION std::vector<std::string> any_message::outside_values() const {
    return text::outside_values(data_->fields(), object_.get());
}
JAUSCAT_FUNCTION std::string any_message::to_text(std::size_t indent) const {
    return text::to_text(data_->fields(), object_.get(), indent);
}

JAUSCAT_FUNCTION text::annotation entry::annotated(std::span<const std::byte> body) const {
    const auto message = decoded(body, true);
    if (!message) return {.fault = data_->diagnose(body, message.error())};
    return text::annotated(data_->fields(), message->object(), body);
}

JAUSCAT_FUNCTION std::string entry::to_text(std::span<const std::byte> body, std::size_t indent) const {
    const auto message = decode(body);
    return message ? message->to_text(indent) : std::string(indent, ' ') + text::to_text(message.error()) + "\n";
}

} // namespace jauscat::catalogue
