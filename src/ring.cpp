// Components in front of the slaves of a ring.
#include <jauscat/bridge/impl/component.ipp>
#include <jauscat/bridge/impl/listed_objects.ipp>
#include <jauscat/bridge/impl/message_lane.ipp>
#include <jauscat/bridge/impl/object_creation.ipp>
#include <jauscat/bridge/impl/order_queue.ipp>
#include <jauscat/bridge/impl/pending_stops.ipp>
#include <jauscat/bridge/impl/process_channel.ipp>
#include <jauscat/bridge/impl/ring.ipp>
#include <jauscat/bridge/impl/ring_clocks.ipp>
#include <jauscat/bridge/impl/supersede.ipp>
