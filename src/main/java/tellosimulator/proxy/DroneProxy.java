package tellosimulator.proxy;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.stream.Collectors;
import tellosimulator.concurrent.Worker;
import tellosimulator.network.PortTakenException;
import tellosimulator.recording.DroneRecorder;
import tellosimulator.sim.SimConfig.StreamPorts;

/**
 * Accepts commands in place of a real drone, forwards them to the drone, and forwards the drone's
 * datagrams back to the operators. The proxy runs until it is closed. Thread-safe.
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
   * Opens the sockets and starts to forward datagrams.
   *
   * @param recorder notified of all traffic, and closed with the proxy
   * @throws PortTakenException if an address or port cannot be opened; the recorder is closed in
   *     this case
   */
  public static DroneProxy start(ProxyPlan plan, DroneRecorder recorder) throws PortTakenException {
    return start(plan, recorder, Relay.Polling.DEFAULT);
  }

  /**
   * Opens the sockets and starts to forward datagrams.
   *
   * @param polling how the proxy detects that this machine has joined another network
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

  /** The addresses where the proxy accepts commands. */
  List<InetSocketAddress> addresses() {
    return relay.addresses();
  }

  /**
   * The ports of this machine to which the drone sends; 0 while the drone cannot reach this
   * machine.
   */
  public StreamPorts streamPorts() {
    return relay.streamPorts();
  }

  /**
   * The line announcing that the proxy is ready. It has the form of the line that a simulator with
   * one drone prints.
   */
  public String ready() {
    return addresses().stream()
        .map(address -> address.getAddress().getHostAddress() + ":" + address.getPort())
        .collect(Collectors.joining(", ", "ready: drone 1 at ", ""));
  }

  /** Stops the proxy and then closes the recording. */
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
