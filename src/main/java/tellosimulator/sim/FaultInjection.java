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
 * Lets the drones of a simulation, and people, know which faults act and how good the link is. For
 * the simulation thread.
 */
final class FaultInjection implements FaultSchedule.Observer {

  private final List<SimDrone> drones;
  private final Supplier<SimTime> now;
  private final Consumer<SimEvent> events;
  private final FaultSchedule schedule;
  private Optional<LinkPreset> link;

  /**
   * @param drones the list itself, in which drones may be replaced
   * @param events takes what begins and ends
   */
  FaultInjection(
      FaultPlan plan, List<SimDrone> drones, Supplier<SimTime> now, Consumer<SimEvent> events) {
    this.drones = drones;
    this.now = now;
    this.events = events;
    this.link = plan.link();
    this.schedule = new FaultSchedule(plan, drones.size(), this);
  }

  /** Lets all drones know, and begins what is to begin at once. */
  void begin() {
    drones.forEach(this::disturb);
    advance();
  }

  /** Begins and ends what is due. */
  void advance() {
    schedule.advance(now.get());
  }

  void inject(Fault fault) {
    schedule.inject(fault, now.get());
  }

  void clear() {
    schedule.clear();
  }

  /** The link of all drones from now on, whatever their behaviour is. */
  void setLink(LinkPreset preset) {
    link = Optional.of(preset);
    drones.forEach(this::disturb);
  }

  /** Lets one drone know. */
  void disturb(SimDrone drone) {
    drone.disturb(link, schedule.acting(drone.number()));
  }

  /** Faults may wait for a command or for a takeoff, and begin anew when a drone is put back. */
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
