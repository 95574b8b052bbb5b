// A translation table between a message and a process image, checked at compile time like the tables into packets.
#pragma once
#include <jauscat/translate/image_rows.hpp>
#include <jauscat/translate/table.hpp>

namespace jauscat::translate {

namespace detail {

struct says_presence {
    template <class Row> static constexpr bool is = requires { typename Row::says_presence; };
};
struct counts_messages {
    template <class Row> static constexpr bool is = requires { typename Row::counts_messages; };
};
// A row about sizes, or that carries the fields that other rows do not use.
struct is_for_packets {
    template <class Row>
    static constexpr bool is = carries_rest::is<Row> || states_body_size::is<Row> || counts_data::is<Row>;
};

} // namespace detail

/// A table between the message `Message` and `Image`, a struct with the layout of a slave's outputs or inputs. Values
/// are those on the wire, scaled ones are integers. Rows: `copy`, `map_values`, `constant`, `caller_set` as in a table
/// into packets; `element`, `presence_bits` and `counter` besides.
template <wire::message Message, wire::fixed_message Image, class... Rows> struct image_table {
    using message_type = Message;
    using image_type = Image;
    using rows = row_list<Rows...>;
    static_assert((detail::require_row<Rows, image_message<Message>, Image>() && ...));
    using message_paths = typename detail::leaves<wire::layout_of<Message>>::type;
    using used = joined_paths<typename Rows::uses...>;
    using written = joined_paths<typename Rows::writes...>;
    static_assert(used::template found_in<message_paths> == used::size &&
                      written::template found_in<paths_of<Image>> == written::size,
                  "image_table: a row names a field that the message or the image does not have");
    static_assert(used::distinct, "image_table: a field of the message is used by two rows");
    static_assert(message_paths::template found_in<used> == message_paths::size,
                  "image_table: a field of the message is used by no row");
    static_assert(written::distinct, "image_table: a field of the image is written by two rows");
    static_assert(paths_of<Image>::template found_in<written> == paths_of<Image>::size,
                  "image_table: a field of the image is not written by any row");
    static_assert(detail::rows_of_kind<detail::is_for_packets, Rows...> == 0,
                  "image_table: an image has a fixed size; rows about sizes and rest are for packets");
    static_assert(detail::rows_of_kind<detail::says_presence, Rows...> <= 1 &&
                      detail::rows_of_kind<detail::counts_messages, Rows...> <= 1,
                  "image_table: presence_bits and counter may be there once");

    /// The rows with the presence bits and with the counter; void where there is none.
    using presence_row = typename detail::row_of_kind<detail::says_presence, Rows...>::type;
    using counter_row = typename detail::row_of_kind<detail::counts_messages, Rows...>::type;

    [[gnu::always_inline]] static constexpr errc to_image(const image_message<Message>& message,
                                                          Image& image) noexcept {
        errc error = errc::ok;
        static_cast<void>((((error = Rows::to_packet(message, image, sizes{})) == errc::ok) && ...));
        return error;
    }
    /// Gives each element of `message` the image's value, which it has while it is absent.
    [[gnu::always_inline]] static constexpr void keep(const Image& image, image_message<Message>& message) noexcept {
        (keep_for<Rows>(image, message), ...);
    }
    [[gnu::always_inline]] static constexpr errc from_image(const Image& image,
                                                            image_message<Message>& message) noexcept {
        errc error = errc::ok;
        const bool set = ((back_unless<detail::says_presence, Rows>(image, message, error)) && ...);
        if constexpr (!std::is_void_v<presence_row>)
            if (set) error = presence_row::from_packet(image, message, sizes{});
        return error;
    }

  private:
    template <class Row>
    [[gnu::always_inline]] static constexpr void keep_for(const Image& image,
                                                          image_message<Message>& message) noexcept {
        if constexpr (requires { Row::keep(image, message); }) Row::keep(image, message);
    }
    template <class Kind, class Row>
    [[gnu::always_inline]] static constexpr bool back_unless(const Image& image, image_message<Message>& message,
                                                             errc& error) noexcept {
        if constexpr (!Kind::template is<Row>) error = Row::from_packet(image, message, sizes{});
        return error == errc::ok;
    }
};

} // namespace jauscat::translate
