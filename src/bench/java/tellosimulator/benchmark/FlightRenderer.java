package tellosimulator.benchmark;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.benchmark.FlightPoses.Moment;
import tellosimulator.model.DroneState;
import tellosimulator.model.FlightPhase;
import tellosimulator.model.Motion;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.video.SoftwareCameras;
import tellosimulator.video.camera.CameraId;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.video.picture.Picture;

/** Films the recorded flight with the software camera, in the default room. */
final class FlightRenderer {

  private final FlightPoses flight = FlightPoses.read(FlightPoses.FILE);
  private final SimSnapshot empty =
      new Simulation(SimConfig.DEFAULT, drone -> datagram -> {}, List.of()).snapshot();
  private final FrameSource camera = new SoftwareCameras(DroneOptics.DEFAULT).get();

  /** The pictures of a part. */
  List<Picture> pictures(FlightPart part) {
    List<Picture> pictures = new ArrayList<>();
    for (Moment moment : flight.part(part)) {
      Picture picture = new Picture(DroneOptics.WIDTH, DroneOptics.HEIGHT);
      film(moment, picture);
      pictures.add(picture);
    }
    return pictures;
  }

  /** How long each picture of a part takes the camera [ms]. */
  List<Double> times(FlightPart part) {
    Picture picture = new Picture(DroneOptics.WIDTH, DroneOptics.HEIGHT);
    return flight.part(part).stream()
        .map(moment -> Stopwatch.ms(() -> film(moment, picture)))
        .toList();
  }

  private void film(Moment moment, Picture picture) {
    camera.film(at(moment), new CameraId(1, false), picture);
  }

  private SimSnapshot at(Moment moment) {
    DroneSnapshot drone = empty.drones().get(0);
    DroneState was = drone.state();
    DroneState now =
        new DroneState(
            was.drone(),
            was.time(),
            Motion.restingAt(moment.pose()),
            FlightPhase.FLYING,
            was.energy(),
            was.reference(),
            was.perception(),
            was.video());
    return empty.withDrones(List.of(drone.withState(now)));
  }
}
