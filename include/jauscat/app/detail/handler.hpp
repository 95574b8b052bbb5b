// The message type of a handler, and the call of one.
#pragma once
#include <jauscat/app/detail/unit.hpp>
#include <jauscat/schema/jaus/command_code.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/diagnose.hpp>
#include <jauscat/wire/encode.hpp>

#include <concepts>
#include <optional>
#include <type_traits>
#include <utility>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

/// Result and parameters of a function whose call operator is no template.
template <class F> struct signature_of {};
template <class F>
requires requires { &F::operator(); }
struct signature_of<F> : signature_of<decltype(&F::operator())> {};
template <class R, class... A> struct signature_of<R (*)(A...)> {
    using result = R;
    template <template <class...> class List> using arguments = List<A...>;
};
template <class R, class... A> struct signature_of<R (*)(A...) noexcept> : signature_of<R (*)(A...)> {};
template <class R, class C, class... A> struct signature_of<R (C::*)(A...)> : signature_of<R (*)(A...)> {};
template <class R, class C, class... A> struct signature_of<R (C::*)(A...) const> : signature_of<R (*)(A...)> {};
template <class R, class C, class... A> struct signature_of<R (C::*)(A...) noexcept> : signature_of<R (*)(A...)> {};
template <class R, class C, class... A>
struct signature_of<R (C::*)(A...) const noexcept> : signature_of<R (*)(A...)> {};

template <class F> concept has_signature = requires { typename signature_of<F>::result; };

template <class... A> struct type_list {
    static constexpr std::size_t size = sizeof...(A);
};
template <class List> struct first_of {
    using type = void;
};
template <class First, class... More> struct first_of<type_list<First, More...>> {
    using type = First;
};
template <class F> using arguments_of = typename signature_of<F>::template arguments<type_list>;
template <class F> using result_of = typename signature_of<F>::result;
/// The type of the first parameter without const and reference; void if there is none.
template <class F> using subject_of = std::remove_cvref_t<typename first_of<arguments_of<F>>::type>;

template <class T> struct without_optional {
    using type = T;
};
template <class T> struct without_optional<std::optional<T>> {
    using type = T;
};
template <class T> using plain = typename without_optional<T>::type;

/// Decodes into `message`; its lists are in the component's memory.
template <class T> wire::errc decode_into(T& message, bytes body, [[maybe_unused]] component_state& component) {
    if constexpr (wire::needs_memory<T>) {
        std::size_t size = 16 * body.size();
        for (;;) {
            wire::arena memory{list_memory(component, size)};
            const auto decoded = wire::decode(message, body, memory);
            if (decoded || decoded.error() != wire::errc::arena_full) return decoded ? wire::errc::ok : decoded.error();
            size = 2 * memory.size();
            message = {};
        }
    } else {
        const auto decoded = wire::decode(message, body);
        return decoded ? wire::errc::ok : decoded.error();
    }
}
template <class T> wire::diagnosis encode_into(std::vector<std::byte>& body, const T& message) {
    body.resize(wire::encoded_size(message));
    return wire::encode(message, body) ? wire::diagnosis{} : wire::diagnose(message);
}

/// Sends what a handler has returned.
template <jaus::coded_message Answer>
jaus::message_outcome send_answer(const incoming& message, const Answer& answer_is) {
    std::vector<std::byte> body;
    if (const auto why = encode_into(body, answer_is); !why) {
        log_not_encodable(message.component, jaus::command_code_of<Answer>, why);
        return jaus::message_outcome::refused;
    }
    return answer(message.component, message.head, jaus::command_code_of<Answer>, body)
               ? jaus::message_outcome::handled
               : jaus::message_outcome::refused;
}

template <class R>
concept handler_result = std::is_void_v<R> || std::same_as<R, jaus::message_outcome> || jaus::coded_message<plain<R>>;

template <class F, class T>
concept handles = std::invocable<F&, const T&> || std::invocable<F&, const T&, const jaus::header&>;

/// Calls `f` with the message, and with its header if it takes one.
template <class T, class F> jaus::message_outcome call(F& f, const T& message, const incoming& from) {
    const auto invoke = [&]() -> decltype(auto) {
        if constexpr (std::invocable<F&, const T&>)
            return f(message);
        else
            return f(message, from.head);
    };
    using result = decltype(invoke());
    if constexpr (std::is_void_v<result>) {
        invoke();
        return jaus::message_outcome::handled;
    } else if constexpr (std::same_as<result, jaus::message_outcome>) {
        return invoke();
    } else if constexpr (jaus::coded_message<result>) {
        return send_answer(from, invoke());
    } else {
        const auto answer_is = invoke();
        return answer_is ? send_answer(from, *answer_is) : jaus::message_outcome::refused;
    }
}

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
