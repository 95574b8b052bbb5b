// The functions of slave.
#pragma once
#include <jauscat/app/impl/bus_state.hpp>
#include <jauscat/app/slave.hpp>

#include <boost/system/system_error.hpp>

#include <utility>

namespace jauscat {
inline namespace JAUSCAT_WAY {

JAUSCAT_DECL slave_info slave::info(boost::system::error_code& error) const {
    const auto locked = bus_->lock();
    const auto* const found = bus_->find(which_, error);
    return found == nullptr ? slave_info{} : found->info;
}
JAUSCAT_DECL slave_info slave::info() const {
    boost::system::error_code error;
    auto found = info(error);
    if (error) throw boost::system::system_error{error};
    return found;
}
JAUSCAT_DECL boost::asio::any_io_executor slave::executor() const noexcept { return bus_->context().get_executor(); }
JAUSCAT_DECL void slave::read(std::uint16_t index, std::uint8_t subindex, const app::object_type& type,
                              app::operation_ptr<app::object_bytes> done) const {
    bus_->read(which_, index, subindex, type, std::move(done));
}
JAUSCAT_DECL void slave::write(std::uint16_t index, std::uint8_t subindex, app::object_bytes bytes,
                               app::operation_ptr<> done) const {
    bus_->write(which_, index, subindex, std::move(bytes), std::move(done));
}
JAUSCAT_DECL void slave::list_objects(ethercat::object_list_type list,
                                      app::operation_ptr<std::vector<std::uint16_t>> done) const {
    bus_->list_objects(which_, list, std::move(done));
}
JAUSCAT_DECL void slave::describe(std::uint16_t index, app::operation_ptr<object_information> done) const {
    bus_->describe(which_, index, std::move(done));
}
JAUSCAT_DECL void slave::describe_entry(std::uint16_t index, std::uint8_t subindex,
                                        app::operation_ptr<entry_information> done) const {
    bus_->describe_entry(which_, index, subindex, std::move(done));
}
JAUSCAT_DECL void slave::state(app::operation_ptr<ethercat::al_status> done) const {
    bus_->state(which_, std::move(done));
}
JAUSCAT_DECL void slave::error_counters(app::operation_ptr<ethercat::error_counters> done) const {
    bus_->error_counters(which_, std::move(done));
}
JAUSCAT_DECL bool slave::is_operating() const { return bus_->data_of(which_).has_value(); }
JAUSCAT_DECL std::span<std::byte> slave::outputs() const {
    const auto data = bus_->data_of(which_);
    return data ? data->outputs : std::span<std::byte>{};
}
JAUSCAT_DECL std::span<const std::byte> slave::inputs() const {
    const auto data = bus_->data_of(which_);
    return data ? data->inputs : std::span<const std::byte>{};
}
JAUSCAT_DECL bool slave::has_current_inputs() const {
    const auto locked = bus_->lock();
    const auto data = bus_->data_of(which_);
    return data && bus_->is_current(*data);
}
JAUSCAT_DECL duration slave::input_age() const {
    const auto data = bus_->data_of(which_);
    return data && data->status.last_inputs ? net::now() - *data->status.last_inputs : duration::max();
}
JAUSCAT_DECL void slave::operate(const operate_options& options, app::operation_ptr<> done) const {
    bus_->operate(which_, options, std::move(done));
}
JAUSCAT_DECL void slave::change(ethercat::al_state goal, app::operation_ptr<> done) const {
    bus_->change(which_, goal, std::move(done));
}

} // namespace JAUSCAT_WAY
} // namespace jauscat
