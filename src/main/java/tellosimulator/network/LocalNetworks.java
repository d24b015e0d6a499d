package tellosimulator.network;

import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.InterfaceAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/** This machine's IPv4 addresses and their networks, as found by one lookup. Immutable. */
public record LocalNetworks(List<Member> members) {

  private static final InetAddress LOOPBACK = AddressPlan.loopback(1);

  /**
   * An address of this machine in a network.
   *
   * @param prefix the length of the network prefix [bits]
   */
  public record Member(InetAddress address, int prefix) {

    boolean sameNetwork(InetAddress other) {
      int mask = prefix == 0 ? 0 : -1 << (Integer.SIZE - prefix);
      return (bits(address) & mask) == (bits(other) & mask);
    }

    private static int bits(InetAddress address) {
      int bits = 0;
      for (byte part : address.getAddress()) {
        bits = (bits << Byte.SIZE) | (part & 0xff);
      }
      return bits;
    }
  }

  public LocalNetworks {
    members = List.copyOf(members);
  }

  /** Looks up the system's addresses. If the lookup fails, returns loopback alone. */
  public static LocalNetworks look() {
    List<Member> members = new ArrayList<>();
    try {
      NetworkInterface.networkInterfaces()
          .flatMap(each -> each.getInterfaceAddresses().stream())
          .filter(each -> each.getAddress() instanceof Inet4Address)
          .map(LocalNetworks::member)
          .distinct()
          .forEach(members::add);
    } catch (SocketException e) {
      members.clear();
    }
    return new LocalNetworks(members);
  }

  private static Member member(InterfaceAddress address) {
    return new Member(address.getAddress(), address.getNetworkPrefixLength());
  }

  /** Returns all addresses of this machine, loopback first. */
  List<InetAddress> addresses() {
    List<InetAddress> addresses = new ArrayList<>(List.of(LOOPBACK));
    members.stream()
        .map(Member::address)
        .filter(address -> !addresses.contains(address))
        .forEach(addresses::add);
    return List.copyOf(addresses);
  }

  /**
   * Returns whether a sender is a neighbour. A neighbour has a private or link-local address (RFC
   * 1918, RFC 3927) in the same network as the address to which it sent the datagram. On loopback,
   * every sender is a neighbour.
   *
   * @param own the address of this machine at which the datagram arrived
   */
  public boolean neighbors(InetAddress own, InetAddress sender) {
    if (own.isLoopbackAddress()) {
      return true;
    }
    if (!sender.isSiteLocalAddress() && !sender.isLinkLocalAddress()) {
      return false;
    }
    for (Member member : members) { // not a stream, because floods pass through here
      if (Objects.equals(member.address(), own) && member.sameNetwork(sender)) {
        return true;
      }
    }
    return false;
  }
}
