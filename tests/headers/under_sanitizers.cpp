// Everything below the I/O line is read with the sanitizers of the user's compiler, and the emulated drive is made:
// what is a constant changes with them.
#include <jauscat/bridge/joints/joint_part.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/jauscat.hpp>

namespace {

template <std::size_t Axes> struct drive {
    jauscat::cia402::emulated_drive<Axes> axes{};
    jauscat::ethercat::standard_objects objects{jauscat::cia402::drive_description<Axes>, axes};
    jauscat::ethercat::slave slave{jauscat::cia402::drive_description<Axes>, objects};
};

template struct drive<1>;
template struct drive<8>;

} // namespace

template class jauscat::bridging::joint_part<6>;
