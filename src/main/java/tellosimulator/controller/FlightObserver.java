package tellosimulator.controller;

/** A listener that is notified of a drone's flight events. Called on the simulation thread. */
@FunctionalInterface
public interface FlightObserver {
  void happened(FlightEvent event);
}
