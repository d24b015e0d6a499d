package tellosimulator.jvm;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mockito.ArgumentMatchers.any;
import static org.mockito.ArgumentMatchers.anyString;
import static org.mockito.Mockito.doThrow;
import static org.mockito.Mockito.inOrder;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.never;
import static org.mockito.Mockito.verify;
import static org.mockito.Mockito.when;

import com.sun.management.HotSpotDiagnosticMXBean;
import com.sun.management.VMOption;
import com.sun.management.VMOption.Origin;
import java.lang.management.ManagementFactory;
import java.util.Optional;
import javax.management.JMException;
import org.junit.jupiter.api.Test;
import org.mockito.InOrder;
import tellosimulator.concurrent.Agent;

class ProcessMemoryTest {

  private final HotSpotDiagnosticMXBean machine = mock(HotSpotDiagnosticMXBean.class);
  private final ProcessMemory memory = new ProcessMemory(() -> Optional.of(machine));

  ProcessMemoryTest() {
    when(machine.getVMOption(anyString())).thenAnswer(call -> option(call.getArgument(0)));
  }

  private static VMOption option(String name) {
    return new VMOption(name, "5000", true, Origin.DEFAULT);
  }

  @Test
  void nothingIsAskedForAtTheStart() throws JMException {
    assertThat(memory.doWork()).isEqualTo(Agent.Outcome.IDLE);

    verify(machine, never()).setVMOption(any(), any());
  }

  @Test
  void theHeapFollowsWhatIsAliveAndTheLeastRatioComesFirst() throws JMException {
    work();

    InOrder order = inOrder(machine);
    order.verify(machine).setVMOption("MinHeapFreeRatio", "10");
    order.verify(machine).setVMOption("MaxHeapFreeRatio", "25");
    order.verify(machine).setVMOption("G1PeriodicGCInterval", "10000");
  }

  @Test
  void whatSomebodyHasSetStays() throws JMException {
    when(machine.getVMOption("MaxHeapFreeRatio"))
        .thenReturn(new VMOption("MaxHeapFreeRatio", "70", true, Origin.VM_CREATION));

    work();

    verify(machine, never()).setVMOption("MaxHeapFreeRatio", "25");
    verify(machine).setVMOption("G1PeriodicGCInterval", "10000");
  }

  @Test
  void anOptionThatIsUnknownOrContradictsAnotherIsLeftOut() throws JMException {
    when(machine.getVMOption("MinHeapFreeRatio")).thenThrow(new IllegalArgumentException());
    doThrow(new IllegalArgumentException()).when(machine).setVMOption("MaxHeapFreeRatio", "25");

    work();

    verify(machine).setVMOption("G1PeriodicGCInterval", "10000");
  }

  @Test
  void aMachineThatTrimsItselfIsLeftAlone() throws JMException {
    assertThat(work()).isEqualTo(Agent.Outcome.FINISHED);
  }

  @Test
  void anotherMachineIsLeftAlone() throws JMException {
    ProcessMemory elsewhere = new ProcessMemory(Optional::empty);
    elsewhere.doWork();

    assertThat(elsewhere.doWork()).isEqualTo(Agent.Outcome.FINISHED);
  }

  @Test
  void theMachineOfTheseTestsTakesAllOptions() throws JMException {
    HotSpotDiagnosticMXBean real =
        ManagementFactory.getPlatformMXBean(HotSpotDiagnosticMXBean.class);
    String least = real.getVMOption("MinHeapFreeRatio").getValue();
    String largest = real.getVMOption("MaxHeapFreeRatio").getValue();
    ProcessMemory here = new ProcessMemory(() -> Optional.of(real));
    try {
      here.doWork();
      here.doWork();

      assertThat(real.getVMOption("MaxHeapFreeRatio").getValue()).isEqualTo("25");
      assertThat(real.getVMOption("MinHeapFreeRatio").getValue()).isEqualTo("10");
    } finally {
      real.setVMOption("MaxHeapFreeRatio", largest);
      real.setVMOption("MinHeapFreeRatio", least);
    }
  }

  private Agent.Outcome work() throws JMException {
    memory.doWork();
    return memory.doWork();
  }
}
