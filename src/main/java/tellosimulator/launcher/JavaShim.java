package tellosimulator.launcher;

import java.io.IOException;
import java.lang.instrument.Instrumentation;
import java.lang.reflect.Method;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.DatagramSocketImpl;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.MulticastSocket;
import java.net.NetworkInterface;
import java.net.SocketAddress;
import java.net.SocketException;
import java.net.SocketOption;
import java.net.SocketOptions;
import java.net.UnknownHostException;
import java.nio.channels.DatagramChannel;
import java.nio.channels.spi.SelectorProvider;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;

/**
 * The shim of {@link ShimNetwork} for Java programs: an agent after which each {@link
 * DatagramSocket} finds simulated drones at the addresses of real ones. {@link DatagramChannel}s
 * are not changed. It is copied into the program's JVM alone, and must not use other classes of
 * this program.
 */
public final class JavaShim {

  private JavaShim() {}

  /** Called by the JVM before the program's main method. */
  @SuppressWarnings("deprecation") // the only way to change DatagramSocket; no replacement exists
  public static void premain(String arguments, Instrumentation jvm) throws Exception {
    String pairs = System.getenv("TELLO_SIMULATOR_SHIM");
    if (pairs != null && !pairs.isEmpty()) {
      Addresses addresses = new Addresses(pairs);
      Method open = uninterruptible(jvm);
      DatagramSocket.setDatagramSocketImplFactory(() -> new ShimmedSocket(addresses, open));
    }
  }

  /**
   * Returns the method of the JDK that opens the channel of a {@link DatagramSocket}. Other
   * channels close when their thread is interrupted.
   */
  private static Method uninterruptible(Instrumentation jvm) throws ReflectiveOperationException {
    Set<Module> here = Set.of(JavaShim.class.getModule());
    jvm.redefineModule(
        Object.class.getModule(),
        Set.of(),
        Map.of(),
        Map.of("sun.nio.ch", here),
        Set.of(),
        Map.of());
    Method open =
        Class.forName("sun.nio.ch.SelectorProviderImpl")
            .getDeclaredMethod("openUninterruptibleDatagramChannel");
    open.setAccessible(true);
    return open;
  }

  /** Translates between the addresses of real drones and those of the simulator. Thread-safe. */
  private static final class Addresses {

    /** The address of a machine that has joined the drone's network. */
    private static final String PROGRAM = "192.168.10.2";

    private final Map<SocketAddress, SocketAddress> simulated = new HashMap<>();
    private final Map<SocketAddress, SocketAddress> real = new HashMap<>();

    Addresses(String pairs) throws UnknownHostException {
      for (String pair : pairs.split(",", -1)) {
        String[] sides = pair.split("=", -1);
        SocketAddress drone = address(sides[0]);
        SocketAddress simulator = address(sides[1]);
        simulated.put(drone, simulator);
        real.put(simulator, drone);
      }
    }

    private static InetSocketAddress address(String text) throws UnknownHostException {
      int colon = text.indexOf(':');
      InetAddress host = InetAddress.getByName(text.substring(0, colon));
      return new InetSocketAddress(host, Integer.parseInt(text.substring(colon + 1)));
    }

    SocketAddress simulated(SocketAddress address) {
      return simulated.getOrDefault(address, address);
    }

    SocketAddress real(SocketAddress address) {
      return real.getOrDefault(address, address);
    }

    /** Returns the address to bind to; any, if the program wants that of a drone's network. */
    static InetAddress local(InetAddress address) throws UnknownHostException {
      return PROGRAM.equals(address.getHostAddress())
          ? InetAddress.getByAddress(new byte[4])
          : address;
    }
  }

  /** A socket whose datagrams are sent by a channel, with translated addresses. */
  private static final class ShimmedSocket extends DatagramSocketImpl {

    private final Addresses addresses;
    private final Method open;
    private MulticastSocket socket;

    ShimmedSocket(Addresses addresses, Method open) {
      this.addresses = addresses;
      this.open = open;
    }

    @Override
    protected void create() throws SocketException {
      try {
        DatagramChannel channel = (DatagramChannel) open.invoke(SelectorProvider.provider());
        socket = (MulticastSocket) channel.socket(); // as its documentation says
      } catch (ReflectiveOperationException e) {
        throw failure(e);
      }
    }

    private static SocketException failure(Exception cause) {
      SocketException failure = new SocketException(cause.getMessage());
      failure.initCause(cause);
      return failure;
    }

    @Override
    protected void bind(int port, InetAddress address) throws SocketException {
      try {
        socket.bind(new InetSocketAddress(Addresses.local(address), port));
      } catch (UnknownHostException e) {
        throw failure(e);
      }
      localPort = socket.getLocalPort();
    }

    @Override
    protected void connect(InetAddress address, int port) throws SocketException {
      socket.connect(addresses.simulated(new InetSocketAddress(address, port)));
    }

    @Override
    protected void disconnect() {
      socket.disconnect();
    }

    @Override
    protected void send(DatagramPacket packet) throws IOException {
      SocketAddress to = addresses.simulated(packet.getSocketAddress());
      socket.send(new DatagramPacket(packet.getData(), packet.getOffset(), packet.getLength(), to));
    }

    @Override
    protected void receive(DatagramPacket packet) throws IOException {
      socket.receive(packet);
      packet.setSocketAddress(addresses.real(packet.getSocketAddress()));
    }

    @Override
    protected int peek(InetAddress address) {
      throw new UnsupportedOperationException("peek"); // called only after connect has failed
    }

    @Override
    protected int peekData(DatagramPacket packet) {
      throw new UnsupportedOperationException("peekData");
    }

    @Override
    protected void close() {
      if (socket != null) {
        socket.close();
      }
    }

    @Override
    protected <T> void setOption(SocketOption<T> name, T value) throws IOException {
      socket.setOption(name, value);
    }

    @Override
    protected <T> T getOption(SocketOption<T> name) throws IOException {
      return socket.getOption(name);
    }

    @Override
    protected Set<SocketOption<?>> supportedOptions() {
      return socket.supportedOptions();
    }

    @Override
    public void setOption(int option, Object value) throws SocketException {
      switch (option) {
        case SocketOptions.SO_TIMEOUT -> socket.setSoTimeout((Integer) value);
        case SocketOptions.SO_REUSEADDR -> socket.setReuseAddress((Boolean) value);
        case SocketOptions.SO_BROADCAST -> socket.setBroadcast((Boolean) value);
        case SocketOptions.SO_RCVBUF -> socket.setReceiveBufferSize((Integer) value);
        case SocketOptions.SO_SNDBUF -> socket.setSendBufferSize((Integer) value);
        case SocketOptions.IP_TOS -> socket.setTrafficClass((Integer) value);
        default -> throw new SocketException("the shim does not support socket option " + option);
      }
    }

    @Override
    public Object getOption(int option) throws SocketException {
      return switch (option) {
        case SocketOptions.SO_TIMEOUT -> socket.getSoTimeout();
        case SocketOptions.SO_REUSEADDR -> socket.getReuseAddress();
        case SocketOptions.SO_BROADCAST -> socket.getBroadcast();
        case SocketOptions.SO_RCVBUF -> socket.getReceiveBufferSize();
        case SocketOptions.SO_SNDBUF -> socket.getSendBufferSize();
        case SocketOptions.IP_TOS -> socket.getTrafficClass();
        case SocketOptions.SO_BINDADDR -> socket.getLocalAddress();
        default -> throw new SocketException("the shim does not support socket option " + option);
      };
    }

    @Override
    protected void setTimeToLive(int hops) throws IOException {
      socket.setTimeToLive(hops);
    }

    @Override
    protected int getTimeToLive() throws IOException {
      return socket.getTimeToLive();
    }

    @Override
    @Deprecated
    protected void setTTL(byte hops) throws IOException {
      socket.setTimeToLive(Byte.toUnsignedInt(hops));
    }

    @Override
    @Deprecated
    protected byte getTTL() throws IOException {
      return (byte) socket.getTimeToLive();
    }

    @Override
    @SuppressWarnings("deprecation")
    protected void join(InetAddress group) throws IOException {
      socket.joinGroup(group);
    }

    @Override
    @SuppressWarnings("deprecation")
    protected void leave(InetAddress group) throws IOException {
      socket.leaveGroup(group);
    }

    @Override
    protected void joinGroup(SocketAddress group, NetworkInterface device) throws IOException {
      socket.joinGroup(group, device);
    }

    @Override
    protected void leaveGroup(SocketAddress group, NetworkInterface device) throws IOException {
      socket.leaveGroup(group, device);
    }
  }
}
