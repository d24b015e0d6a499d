package tellosimulator.sim;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import tellosimulator.controller.FlightEvent;
import tellosimulator.fault.Fault;
import tellosimulator.fault.FaultPlan;
import tellosimulator.fault.FaultSchedule;
import tellosimulator.fault.LinkPreset;
import tellosimulator.time.SimTime;

/**
 * Applies the active faults and the link quality to the drones of a simulation, and reports when
 * faults begin and end. Confined to the simulation thread.
 */
final class FaultInjection implements FaultSchedule.Observer {

  private final List<SimDrone> drones;
  private final Supplier<SimTime> now;
  private final Consumer<SimEvent> events;
  private final FaultSchedule schedule;
  private Optional<LinkPreset> link;

  /**
   * Creates the fault injection for a simulation's drones.
   *
   * @param drones the live list; drones in it may be replaced
   * @param events receives an event whenever a fault begins or ends
   */
  FaultInjection(
      FaultPlan plan, List<SimDrone> drones, Supplier<SimTime> now, Consumer<SimEvent> events) {
    this.drones = drones;
    this.now = now;
    this.events = events;
    this.link = plan.link();
    this.schedule = new FaultSchedule(plan, drones.size(), this);
  }

  /** Applies the link quality to all drones, and begins the faults that have no trigger. */
  void begin() {
    drones.forEach(this::disturb);
    advance();
  }

  /** Begins and ends the faults that are due. */
  void advance() {
    schedule.advance(now.get());
  }

  void inject(Fault fault) {
    schedule.inject(fault, now.get());
  }

  void clear() {
    schedule.clear();
  }

  /** Sets the link quality of all drones, and thus overrides the default of their behaviour. */
  void setLink(LinkPreset preset) {
    link = Optional.of(preset);
    drones.forEach(this::disturb);
  }

  /** Applies the current faults and link quality to a drone. */
  void disturb(SimDrone drone) {
    drone.disturb(link, schedule.acting(drone.number()));
  }

  /**
   * Observes an event. A command or a takeoff can trigger faults. A reset restarts the faults of
   * the plan.
   */
  void observe(SimEvent event) {
    if (event instanceof SimEvent.CommandReceived command) {
      schedule.commanded(command.drone(), command.text(), now.get());
    } else if (event instanceof SimEvent.DroneFlight flight) {
      if (flight.event() instanceof FlightEvent.TookOff) {
        schedule.tookOff(now.get());
      } else if (flight.event() instanceof FlightEvent.PutBack) {
        schedule.restart(now.get());
      }
    }
  }

  @Override
  public void began(int drone, Fault fault) {
    events.accept(new SimEvent.FaultBegan(now.get(), drone, fault));
    disturb(drones.get(drone - 1));
  }

  @Override
  public void ended(int drone, Fault fault) {
    events.accept(new SimEvent.FaultEnded(now.get(), drone, fault));
    disturb(drones.get(drone - 1));
  }
}
