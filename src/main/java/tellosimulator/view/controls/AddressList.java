package tellosimulator.view.controls;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import javafx.scene.control.Hyperlink;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.text.Messages;

/**
 * Where a drone takes commands, the most useful address first, each with a button that copies it.
 * More than a few are folded away. For the JavaFX thread.
 */
final class AddressList extends VBox {

  /** Addresses that are always shown. Decided: the network's, this machine's. */
  private static final int SHOWN = 2;

  private final Messages messages;
  private final VBox rest = new VBox();
  private final Hyperlink more = new Hyperlink();
  private List<InetSocketAddress> shown = List.of();

  AddressList(Messages messages) {
    this.messages = messages;
    initializeSelf();
    initializeParts();
    setupEventHandlers();
  }

  private void initializeSelf() {
    setId("addresses");
    getStyleClass().add("address-list");
  }

  private void initializeParts() {
    more.setId("more-addresses");
    rest.getStyleClass().add("address-list");
    unfold(false);
  }

  private void setupEventHandlers() {
    more.setOnAction(pressed -> unfold(true));
  }

  /** Shows addresses, if they are not shown already. */
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
    more.setVisible(!open);
    more.setManaged(!open);
    rest.setVisible(open);
    rest.setManaged(open);
  }

  private HBox row(int index, InetSocketAddress address) {
    String text = text(address);
    Label label = new Label(text);
    label.setId("address-" + index);
    label.getStyleClass().add("address");
    label.setMaxWidth(Double.MAX_VALUE);
    label.setMinWidth(USE_PREF_SIZE);
    HBox.setHgrow(label, Priority.ALWAYS);
    String key = address.getAddress().isLoopbackAddress() ? "address.loopback" : "address.network";
    Label reach = messages.label(key, "caption");
    Tooltips.install(reach, messages.text(key + ".hint"));
    CopyButton copy = new CopyButton(messages.text("address.copy", text), () -> text);
    copy.setId("copy-address-" + index);
    copy.getStyleClass().add("icon-button");
    HBox row = new HBox(label, reach, copy);
    row.getStyleClass().add("row");
    return row;
  }

  /**
   * The address that other machines of the local network probably reach, then loopback for programs
   * on this machine, then all others.
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
   * Low for addresses that local networks have. Assumed: homes and schools use 192.168 and 10;
   * 172.16 to 172.31 is mostly the inner network of containers.
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

  /** An address as people type it; without a port that is not chosen yet. */
  static String text(InetSocketAddress address) {
    String host = address.getAddress().getHostAddress();
    return address.getPort() == 0 ? host : host + ":" + address.getPort();
  }
}
