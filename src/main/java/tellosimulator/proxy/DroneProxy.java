package tellosimulator.proxy;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.stream.Collectors;
import tellosimulator.concurrent.Worker;
import tellosimulator.network.PortTakenException;
import tellosimulator.recording.DroneRecorder;
import tellosimulator.sim.SimConfig.StreamPorts;

/**
 * Takes commands in the place of a real drone, and passes them to it and back what it sends, until
 * it is closed. For any thread.
 */
public final class DroneProxy implements AutoCloseable {

  private final Relay relay;
  private final Worker worker;
  private final DroneRecorder recorder;
  private boolean closed;

  private DroneProxy(Relay relay, DroneRecorder recorder) {
    this.relay = relay;
    this.recorder = recorder;
    this.worker = Worker.start("proxy", relay);
  }

  /**
   * Opens the sockets and begins.
   *
   * @param recorder is told what passes, and closed with this
   * @throws PortTakenException if an address or port cannot be had; then the recorder is closed
   */
  public static DroneProxy start(ProxyPlan plan, DroneRecorder recorder) throws PortTakenException {
    return start(plan, recorder, Relay.Polling.DEFAULT);
  }

  /**
   * The same.
   *
   * @param polling how it notices that this machine has joined another network
   */
  static DroneProxy start(ProxyPlan plan, DroneRecorder recorder, Relay.Polling polling)
      throws PortTakenException {
    try {
      return new DroneProxy(Relay.open(plan, recorder, polling), recorder);
    } catch (PortTakenException | RuntimeException e) {
      recorder.close();
      throw e;
    }
  }

  /** Where it takes commands. */
  List<InetSocketAddress> addresses() {
    return relay.addresses();
  }

  /** The ports of this machine to which the drone sends; 0 while none can be reached by it. */
  public StreamPorts streamPorts() {
    return relay.streamPorts();
  }

  /** The line that says that it is ready, as a simulator with one drone says it. */
  public String ready() {
    return addresses().stream()
        .map(address -> address.getAddress().getHostAddress() + ":" + address.getPort())
        .collect(Collectors.joining(", ", "ready: drone 1 at ", ""));
  }

  /** Ends it, and then the recording. */
  @Override
  public synchronized void close() {
    if (closed) {
      return;
    }
    closed = true;
    relay.end();
    worker.close();
    recorder.close();
  }
}
