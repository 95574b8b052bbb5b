// Reference to a user's function. One with other parameters or another result does not compile.
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

namespace jauscat::jaus {

/// A member function of an object, see `bound`.
template <auto Function, class Object> struct bound_member {
    Object* object;
};
/// A member function of an object, which must outlive the hook: `jaus::bound<&driver::on_state>(*this)`.
template <auto Function, class Object> [[nodiscard]] constexpr bound_member<Function, Object> bound(Object& object) {
    return {&object};
}

namespace detail {

template <class F, class Signature> struct hook_call;
template <class F, class Result, class... Arguments> struct hook_call<F, Result(Arguments...)> {
    static constexpr bool has_parameters = std::invocable<F&, Arguments...>;
    using result = std::invoke_result<F&, Arguments...>;
};
template <auto Function, class Object, class Result, class... Arguments>
struct hook_call<bound_member<Function, Object>, Result(Arguments...)> {
    static constexpr bool has_parameters = std::invocable<decltype(Function), Object&, Arguments...>;
    using result = std::invoke_result<decltype(Function), Object&, Arguments...>;
};
template <class Signature> struct result_of;
template <class Result, class... Arguments> struct result_of<Result(Arguments...)> {
    using type = Result;
};

} // namespace detail

/// A function for a hook of this signature: a callable object, or what `bound` returns. It can be called with the
/// arguments of the signature and returns exactly its result.
template <class F, class Signature>
concept hook_function =
    detail::hook_call<F, Signature>::has_parameters &&
    std::same_as<typename detail::hook_call<F, Signature>::result::type, typename detail::result_of<Signature>::type>;

/// Refers to a function, or to none. It is called with the arguments of `Signature` and returns exactly its result.
template <class Signature> class hook;

/// Constructed from `bound`, or from a callable object that outlives it: see hook_function.
template <class Result, class... Arguments> class hook<Result(Arguments...)> {
  public:
    constexpr hook() noexcept = default;
    /// Refers to `function`.
    template <class F>
    requires(!std::same_as<std::remove_cvref_t<F>, hook> && std::is_class_v<std::remove_cvref_t<F>>)
    constexpr hook(F&& function) noexcept : object_{const_cast<void*>(static_cast<const void*>(&function))} {
        static_assert(std::is_lvalue_reference_v<F>, "hook: the function must outlive the component: give it a name");
        if constexpr (fits<std::remove_reference_t<F>>())
            call_ = [](void* object, Arguments... arguments) -> Result {
                return (*static_cast<std::remove_reference_t<F>*>(object))(std::forward<Arguments>(arguments)...);
            };
    }
    /// Refers to a member function.
    template <auto Function, class Object>
    constexpr hook(bound_member<Function, Object> member) noexcept
        : object_{const_cast<void*>(static_cast<const void*>(member.object))} {
        if constexpr (fits<bound_member<Function, Object>>())
            call_ = [](void* object, Arguments... arguments) -> Result {
                return (static_cast<Object*>(object)->*Function)(std::forward<Arguments>(arguments)...);
            };
    }

    [[nodiscard]] constexpr explicit operator bool() const noexcept { return call_ != nullptr; }
    /// Without a function: does nothing. One with a result must refer to a function.
    constexpr Result operator()(Arguments... arguments) const {
        if constexpr (std::is_void_v<Result>)
            if (call_ == nullptr) return;
        return call_(object_, std::forward<Arguments>(arguments)...);
    }

  private:
    template <class F> [[nodiscard]] static consteval bool fits() {
        constexpr bool has_parameters = detail::hook_call<F, Result(Arguments...)>::has_parameters;
        static_assert(has_parameters, "hook: the function has other parameters than the hook");
        if constexpr (has_parameters)
            static_assert(hook_function<F, Result(Arguments...)>,
                          "hook: the function returns another type than the hook");
        return hook_function<F, Result(Arguments...)>;
    }

    void* object_{};
    Result (*call_)(void*, Arguments...){};
};

} // namespace jauscat::jaus
