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

/// Refers to a function, or to none. It is called with the arguments of `Signature` and returns exactly its result.
template <class Signature> class hook;

/// Constructed from `bound`, or from a callable object that outlives it.
template <class Result, class... Arguments> class hook<Result(Arguments...)> {
  public:
    constexpr hook() noexcept = default;
    /// Refers to `function`.
    template <class F>
    requires(!std::same_as<std::remove_cvref_t<F>, hook> && std::is_class_v<std::remove_cvref_t<F>>)
    constexpr hook(F&& function) noexcept : object_{const_cast<void*>(static_cast<const void*>(&function))} {
        static_assert(std::is_lvalue_reference_v<F>, "hook: the function must outlive the component: give it a name");
        if constexpr (fits<F&>())
            call_ = [](void* object, Arguments... arguments) -> Result {
                return (*static_cast<std::remove_reference_t<F>*>(object))(std::forward<Arguments>(arguments)...);
            };
    }
    /// Refers to a member function.
    template <auto Function, class Object>
    constexpr hook(bound_member<Function, Object> member) noexcept
        : object_{const_cast<void*>(static_cast<const void*>(member.object))} {
        if constexpr (fits<decltype(Function), Object&>())
            call_ = [](void* object, Arguments... arguments) -> Result {
                return (static_cast<Object*>(object)->*Function)(std::forward<Arguments>(arguments)...);
            };
    }

    [[nodiscard]] constexpr explicit operator bool() const noexcept { return call_ != nullptr; }
    /// Not for a hook that refers to none.
    constexpr Result operator()(Arguments... arguments) const {
        return call_(object_, std::forward<Arguments>(arguments)...);
    }

  private:
    template <class F, class... Object> [[nodiscard]] static consteval bool fits() {
        if constexpr (std::invocable<F, Object..., Arguments...>) {
            constexpr bool returns_it = std::same_as<std::invoke_result_t<F, Object..., Arguments...>, Result>;
            static_assert(returns_it, "hook: the function returns another type than the hook");
            return returns_it;
        } else {
            static_assert(sizeof...(Object) > 1, "hook: the function has other parameters than the hook");
            return false;
        }
    }

    void* object_{};
    Result (*call_)(void*, Arguments...){};
};

} // namespace jauscat::jaus
