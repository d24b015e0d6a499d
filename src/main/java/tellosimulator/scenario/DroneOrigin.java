package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import tellosimulator.scenario.Scenario.CommandAddress;
import tellosimulator.sim.DroneSetup;

/**
 * The origin of a drone in an opened scenario: the drone's setup when the scenario was opened, and
 * its setup in the document. The two differ if an option that applies to all scenarios overrides
 * the document. Immutable.
 *
 * @param opened the drone's setup when the scenario was opened
 * @param station the drone's command address when the scenario was opened
 * @param written the drone's setup in the document
 * @param writtenStation the drone's command address in the document
 */
public record DroneOrigin(
    DroneSetup opened, CommandAddress station, DroneSetup written, CommandAddress writtenStation) {

  /**
   * Returns the origins of all drones of a scenario.
   *
   * @param written the scenario in the document
   * @param opened the scenario as it was opened, with the same number of drones
   */
  static List<DroneOrigin> of(Scenario written, Scenario opened) {
    List<DroneOrigin> origins = new ArrayList<>();
    for (int i = 0; i < opened.stations().size(); i++) {
      origins.add(
          new DroneOrigin(
              opened.config().drones().get(i),
              opened.stations().get(i),
              written.config().drones().get(i),
              written.stations().get(i)));
    }
    return List.copyOf(origins);
  }

  /**
   * Returns an origin for an additional drone of the same product. The drone has the same ports,
   * and the default address and colour for its number.
   */
  public DroneOrigin another() {
    return new DroneOrigin(
        opened.withColor(OptionalInt.empty()),
        new CommandAddress(Optional.empty(), station.port()),
        written.withColor(OptionalInt.empty()),
        new CommandAddress(Optional.empty(), writtenStation.port()));
  }

  /**
   * Returns a copy of this origin with another colour.
   *
   * @param rgb the colour as {@code 0xrrggbb}
   */
  public DroneOrigin painted(int rgb) {
    return new DroneOrigin(
        opened.withColor(OptionalInt.of(rgb)),
        station,
        written.withColor(OptionalInt.of(rgb)),
        writtenStation);
  }

  /**
   * Returns the drone to be saved. Its current start, product and stream ports are saved only if
   * they have changed since the scenario was opened, so that values from options are not saved.
   *
   * @param now the drone's current setup
   */
  DroneSetup toSave(DroneSetup now) {
    return written
        .withStart(EditedScenario.changed(written.start(), opened.start(), now.start()))
        .withProduct(EditedScenario.changed(written.product(), opened.product(), now.product()))
        .withStreamPorts(
            EditedScenario.changed(written.streamPorts(), opened.streamPorts(), now.streamPorts()));
  }
}
