package tellosimulator.controller;

/** Is told what happens to a drone. Called on the simulation thread. */
@FunctionalInterface
public interface FlightObserver {
  void happened(FlightEvent event);
}
