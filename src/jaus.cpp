// Components, events, routing and large data sets of JAUS.
#include <jauscat/jaus/component/impl/acknowledged_receiver.ipp>
#include <jauscat/jaus/component/impl/acknowledged_sender.ipp>
#include <jauscat/jaus/component/impl/component_clock.ipp>
#include <jauscat/jaus/component/impl/component_control.ipp>
#include <jauscat/jaus/component/impl/component_state.ipp>
#include <jauscat/jaus/component/impl/described_component.ipp>
#include <jauscat/jaus/component/impl/held_control.ipp>
#include <jauscat/jaus/events/impl/event_condition.ipp>
#include <jauscat/jaus/events/impl/event_record.ipp>
#include <jauscat/jaus/events/impl/requested_event.ipp>
#include <jauscat/jaus/large_data/impl/reassembler.ipp>
#include <jauscat/jaus/routing/impl/liveness_table.ipp>
#include <jauscat/jaus/routing/impl/node_manager.ipp>
#include <jauscat/jaus/routing/impl/router.ipp>
#include <jauscat/jaus/routing/impl/routing_table.ipp>
