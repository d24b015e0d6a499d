package tellosimulator.endurance;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * A machine between a client and a drone that passes on what comes, as a router that translates
 * addresses does, and disturbs it: each datagram by chance, from a seed. The client takes it for
 * the drone, the drone for the client.
 */
final class Forwarder {

  /** Of all datagrams, in each direction. */
  private static final double SHARE = 0.2;

  /** How much later all datagrams come where they are delayed [ns]. */
  private static final long DELAY = 200_000_000;

  /** How much later some come than they should, so that others overtake them [ns]. */
  private static final long HELD = 120_000_000;

  private static final int COMMAND_PORT = 8889;

  /** State and video, which only come from the drone. */
  private static final List<Integer> PORTS_OF_CLIENT = List.of(8890, 11_111);

  /** What it does to datagrams. */
  enum Disturbance {
    LOSS,
    DELAY,
    DUPLICATE,
    REORDER
  }

  /** What becomes of a datagram that came to a socket: by which one it goes on, and to whom. */
  private record Route(DatagramChannel by, SocketAddress to) {}

  /** A datagram that is sent when its time has come. */
  private record Delayed(long due, long number, ByteBuffer bytes, Route route) {}

  private final Selector selector = Selector.open();
  private final InetSocketAddress drone;
  private final List<Disturbance> disturbances;
  private final Random random;
  private final PriorityQueue<Delayed> waiting =
      new PriorityQueue<>(Comparator.comparingLong(Delayed::due).thenComparing(Delayed::number));

  /** The sockets towards the drone, one for each of the client's. */
  private final Map<SocketAddress, DatagramChannel> clients = new HashMap<>();

  private final DatagramChannel commands;
  private final AtomicInteger taken = new AtomicInteger();
  private final AtomicInteger disturbed = new AtomicInteger();
  private long numbers;

  private Forwarder(String droneAddress, String client, List<Disturbance> disturbances, long seed)
      throws IOException {
    drone = new InetSocketAddress(droneAddress, COMMAND_PORT);
    this.disturbances = disturbances;
    random = new Random(seed);
    commands = open(COMMAND_PORT);
    commands.register(selector, SelectionKey.OP_READ);
    for (int port : PORTS_OF_CLIENT) {
      DatagramChannel socket = open(port);
      Route route = new Route(socket, new InetSocketAddress(client, port));
      socket.register(selector, SelectionKey.OP_READ, route);
    }
  }

  /**
   * Prints {@code passing}; and, for each line that it is told, {@code taken N disturbed N}. Ends
   * with its input.
   *
   * @param arguments address of the drone and of the client, seed, and disturbances with commas
   *     between them
   */
  public static void main(String[] arguments) throws IOException {
    List<Disturbance> disturbances =
        Arrays.stream(arguments[3].split(",", -1)).map(Disturbance::valueOf).toList();
    Forwarder forwarder =
        new Forwarder(arguments[0], arguments[1], disturbances, Long.parseLong(arguments[2]));
    Daemon.start("forwarder", forwarder::pass);
    System.out.println("passing");
    try (BufferedReader input =
        new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8))) {
      while (input.readLine() != null) {
        System.out.println("taken " + forwarder.taken + " disturbed " + forwarder.disturbed);
      }
    }
  }

  private static DatagramChannel open(int port) throws IOException {
    DatagramChannel socket = DatagramChannel.open().bind(new InetSocketAddress(port));
    socket.configureBlocking(false);
    return socket;
  }

  private void pass() {
    try {
      while (true) {
        Delayed next = waiting.peek();
        if (next == null) {
          selector.select();
        } else {
          long pause = (next.due() - System.nanoTime()) / 1_000_000;
          if (pause > 0) {
            selector.select(pause);
          } else {
            selector.selectNow();
          }
        }
        for (SelectionKey key : List.copyOf(selector.selectedKeys())) {
          take(key);
        }
        selector.selectedKeys().clear();
        sendDue();
      }
    } catch (IOException e) {
      System.out.println("failed " + e.getMessage());
    }
  }

  private void take(SelectionKey key) throws IOException {
    DatagramChannel socket = (DatagramChannel) key.channel();
    ByteBuffer buffer = ByteBuffer.allocate(2048);
    SocketAddress from = socket.receive(buffer);
    while (from != null) {
      Route route =
          key.attachment() instanceof Route known ? known : new Route(towardsDrone(from), drone);
      disturb(buffer.flip(), route);
      buffer = ByteBuffer.allocate(2048);
      from = socket.receive(buffer);
    }
  }

  /** Replies that come to it go back to this socket of the client. */
  private DatagramChannel towardsDrone(SocketAddress client) throws IOException {
    DatagramChannel known = clients.get(client);
    if (known != null) {
      return known;
    }
    DatagramChannel socket = open(0);
    socket.register(selector, SelectionKey.OP_READ, new Route(commands, client));
    clients.put(client, socket);
    return socket;
  }

  private void disturb(ByteBuffer bytes, Route route) {
    taken.incrementAndGet();
    boolean lost = happens(Disturbance.LOSS);
    boolean twice = happens(Disturbance.DUPLICATE);
    boolean held = happens(Disturbance.REORDER);
    boolean late = disturbances.contains(Disturbance.DELAY);
    if (lost || twice || held || late) {
      disturbed.incrementAndGet();
    }
    if (lost) {
      return;
    }
    long due = System.nanoTime() + (late ? DELAY : 0);
    add(due + (held ? HELD : 0), bytes, route);
    if (twice) {
      add(due, bytes.duplicate(), route);
    }
  }

  private boolean happens(Disturbance disturbance) {
    return disturbances.contains(disturbance) && random.nextDouble() < SHARE;
  }

  private void add(long due, ByteBuffer bytes, Route route) {
    waiting.add(new Delayed(due, numbers++, bytes, route));
  }

  private void sendDue() throws IOException {
    List<Delayed> due = new ArrayList<>();
    while (!waiting.isEmpty() && waiting.peek().due() <= System.nanoTime()) {
      due.add(waiting.remove());
    }
    for (Delayed datagram : due) {
      datagram.route().by().send(datagram.bytes(), datagram.route().to());
    }
  }
}
