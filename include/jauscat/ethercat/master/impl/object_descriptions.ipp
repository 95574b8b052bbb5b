// The functions of object_descriptions.
#pragma once
#include <jauscat/ethercat/master/object_descriptions.hpp>

namespace jauscat::ethercat::detail {

JAUSCAT_FUNCTION std::string_view name_in(std::span<const std::byte> bytes) noexcept {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

} // namespace jauscat::ethercat::detail

namespace jauscat::ethercat {

JAUSCAT_FUNCTION master_result<object_description>
decode_object_description(std::span<const std::byte> bytes) noexcept {
    object_description description{.bytes = bytes};
    const auto used = wire::decode_prefix(description.object, bytes);
    if (!used) return master_error{.code = master_errc::unexpected_reply};
    description.name = detail::name_in(bytes.subspan(*used));
    return description;
}

JAUSCAT_FUNCTION master_result<entry_description> decode_entry_description(std::span<const std::byte> bytes) noexcept {
    enum : unsigned { unit = 0x08, default_value = 0x10, minimum = 0x20, maximum = 0x40 };
    entry_description description{.bytes = bytes};
    const auto used = wire::decode_prefix(description.entry, bytes);
    if (!used) return master_error{.code = master_errc::unexpected_reply};
    auto rest = bytes.subspan(*used);
    const auto take = [&](unsigned what, std::size_t size) {
        if ((description.entry.value_info & what) == 0 || size > rest.size()) return std::span<const std::byte>{};
        const auto value = rest.first(size);
        rest = rest.subspan(size);
        return value;
    };
    const std::size_t size = (description.entry.bits + 7u) / 8;
    if (const auto value = take(unit, sizeof(std::uint32_t)); !value.empty()) {
        description.unit = 0;
        for (std::size_t i = value.size(); i-- != 0;)
            description.unit = *description.unit << 8 | std::to_integer<std::uint32_t>(value[i]);
    }
    description.default_value = take(default_value, size);
    description.minimum = take(minimum, size);
    description.maximum = take(maximum, size);
    description.name = detail::name_in(rest);
    return description;
}

} // namespace jauscat::ethercat
