package tellosimulator.endurance;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.network.PortTakenException;
import tellosimulator.sim.SimConfig;
import tellosimulator.video.Recording;
import tellosimulator.video.SoftwareCameras;
import tellosimulator.video.VideoStreams;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.video.codec.H264Encoder;

/** A program that records the film of a drone as the window does, until it is killed. */
final class Recorder {

  private Recorder() {}

  /**
   * Prints {@code recorded N} after each picture.
   *
   * @param arguments the file to record to
   */
  public static void main(String[] arguments) throws IOException, PortTakenException {
    AddressPlan plan = AddressPlan.portPerDrone(1, List.of(InetAddress.getLoopbackAddress()), 0);
    try (OnlineSimulation simulation =
            new OnlineSimulation(SimConfig.DEFAULT, plan, OptionalInt.empty(), List.of());
        VideoStreams video =
            VideoStreams.of(
                simulation, new SoftwareCameras(DroneOptics.DEFAULT), H264Encoder::new);
        Recording recording = Recording.to(Path.of(arguments[0]))) {
      simulation.switchAllOn();
      video.stream(1).watch(recording);
      int told = 0;
      while (true) {
        if (recording.pictures() > told) {
          told = recording.pictures();
          System.out.println("recorded " + told);
        }
        Waiting.pass(Waiting.SHORT);
      }
    }
  }
}
