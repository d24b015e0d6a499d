package tellosimulator.view.controls;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import javafx.scene.control.Hyperlink;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.VBox;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.text.Messages;

/**
 * A list of the addresses at which a drone accepts commands. The most useful address is at the top.
 * Each address has a button that copies it. All addresses except the first few are hidden until the
 * user unfolds them. Confined to the JavaFX thread.
 */
final class AddressList extends VBox {

  /**
   * The number of addresses that are always shown. Decided: one for the network and one for this
   * machine.
   */
  private static final int SHOWN = 2;

  private final Messages messages;
  private final VBox rest = Nodes.styled(new VBox(), "address-list");
  private final Hyperlink more = Nodes.named(new Hyperlink(), "more-addresses");
  private List<InetSocketAddress> shown = List.of();

  AddressList(Messages messages) {
    this.messages = messages;
    Nodes.named(this, "addresses", "address-list");
    unfold(false);
    more.setOnAction(pressed -> unfold(true));
  }

  /** Shows addresses, unless they are already shown. */
  void show(List<InetSocketAddress> addresses) {
    List<InetSocketAddress> ordered = mostUsefulFirst(addresses);
    if (ordered.equals(shown)) {
      return;
    }
    shown = ordered;
    getChildren().clear();
    rest.getChildren().clear();
    for (int i = 0; i < ordered.size(); i++) {
      (i < SHOWN ? this : rest).getChildren().add(row(i, ordered.get(i)));
    }
    if (ordered.size() > SHOWN) {
      more.textProperty()
          .bind(messages.text("address.more", Integer.toString(ordered.size() - SHOWN)));
      getChildren().addAll(more, rest);
    }
  }

  private void unfold(boolean open) {
    Nodes.setShown(more, !open);
    Nodes.setShown(rest, open);
  }

  private HBox row(int index, InetSocketAddress address) {
    String text = text(address);
    Label label = Nodes.named(new Label(text), "address-" + index, "address");
    Nodes.growing(Nodes.unshrinkable(label));
    String key = address.getAddress().isLoopbackAddress() ? "address.loopback" : "address.network";
    Label reach = messages.label(key, "caption");
    Tooltips.install(reach, messages.text(key + ".hint"));
    CopyButton copy =
        Nodes.named(
            new CopyButton(messages.text("address.copy", text), () -> text),
            "copy-address-" + index,
            "icon-button");
    HBox row = Nodes.styled(new HBox(label, reach, copy), "row");
    return row;
  }

  /**
   * Orders addresses: first the address that other machines on the local network are most likely to
   * reach, then the loopback address for programs on this machine, and then all others.
   */
  static List<InetSocketAddress> mostUsefulFirst(List<InetSocketAddress> addresses) {
    List<InetSocketAddress> ordered = new ArrayList<>(addresses);
    ordered.sort(Comparator.comparingInt(address -> rank(address.getAddress())));
    int loopback = 0;
    while (loopback < ordered.size() && !ordered.get(loopback).getAddress().isLoopbackAddress()) {
      loopback++;
    }
    if (loopback > 1 && loopback < ordered.size()) {
      ordered.add(1, ordered.remove(loopback));
    }
    return List.copyOf(ordered);
  }

  /**
   * Returns the rank of an address; addresses of local networks rank first. Assumed: homes and
   * schools use addresses that begin with 192.168 or 10; addresses that begin with 172.16 to 172.31
   * usually belong to internal networks of containers.
   */
  private static int rank(InetAddress address) {
    byte[] bytes = address.getAddress();
    if (address.isLoopbackAddress()) {
      return 4;
    }
    if (address.isLinkLocalAddress()) {
      return 3;
    }
    if (address.isSiteLocalAddress()) {
      return (bytes[0] & 0xff) == 172 ? 2 : 0;
    }
    return 1;
  }

  /** Returns the most useful address, formatted as users type it. */
  static String mostUseful(List<InetSocketAddress> addresses) {
    return text(mostUsefulFirst(addresses).get(0));
  }

  /** Formats an address as users type it; the port is omitted if it has not been chosen yet. */
  static String text(InetSocketAddress address) {
    String host = address.getAddress().getHostAddress();
    return address.getPort() == 0 ? host : host + ":" + address.getPort();
  }
}
