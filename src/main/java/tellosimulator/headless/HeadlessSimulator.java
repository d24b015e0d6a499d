package tellosimulator.headless;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintStream;
import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.CountDownLatch;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.network.PortTakenException;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.SoftwareCameras;
import tellosimulator.video.VideoStreams;
import tellosimulator.video.codec.H264Encoder;

/** The program without a window: drones that are on, a console, and a line when it is ready. */
public final class HeadlessSimulator implements AutoCloseable {

  private final OnlineSimulation simulation;
  private final VideoStreams video;

  /**
   * Opens the sockets and starts the simulation; all drones are on.
   *
   * @param replyPort port to which all replies go; empty for the port each command came from
   * @param cameras makes one for each drone
   * @throws PortTakenException if an address or port cannot be had
   */
  public HeadlessSimulator(
      SimConfig config, AddressPlan plan, OptionalInt replyPort, SoftwareCameras cameras)
      throws PortTakenException {
    simulation = new OnlineSimulation(config, plan, replyPort, List.of(new EventLog()));
    video = VideoStreams.of(simulation, cameras, H264Encoder::new);
    try {
      simulation.switchAllOn();
    } catch (PortTakenException e) {
      close();
      throw e;
    }
  }

  /** Says that it is ready, and where the drones are. */
  public void sayReady(PrintStream out) {
    shrinkHeap();
    out.println(simulation.ready());
    out.flush();
  }

  /** Takes what is typed; returns after {@code quit}, and never if the input ends without it. */
  public void run(BufferedReader in, PrintStream out) throws IOException, InterruptedException {
    if (!new Console(simulation::snapshot, simulation::carryOut, in, out).run()) {
      new CountDownLatch(1).await();
    }
  }

  /** A recent state of everything; for any thread. */
  public SimSnapshot snapshot() {
    return simulation.snapshot();
  }

  /**
   * Gives memory back. The JVM starts with a sixty-fourth of the machine's memory as heap and fills
   * it before it collects for the second time; a full collection lets it adopt the few megabytes
   * that a simulation needs.
   */
  private static void shrinkHeap() {
    System.gc();
  }

  @Override
  public void close() {
    video.close();
    simulation.close();
  }
}
