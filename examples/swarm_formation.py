"""Flies a formation with djitellopy's TelloSwarm, which is used as it is.

A swarm tells its drones apart by their addresses alone: all of them listen on port 8889, as this
program does, so they cannot share a network stack with it. Real ones (Tello EDU) have the addresses
that your access point gave them. Simulated ones get an address each on another computer, or in a
private network (Linux):

    pip install djitellopy
    java -jar target/tello-simulator.jar run --headless --drones 3 -- \\
      python examples/swarm_formation.py 192.168.10.11 192.168.10.12 192.168.10.13

They stand side by side, 60 cm apart, the first one at the left.
"""

import sys

from djitellopy import Tello, TelloSwarm

WEDGE_CM = 40  # how far a drone is ahead of its neighbour who is nearer to an end
STAIRS_CM = 20  # how much higher each drone flies than the one to its left


def fly(swarm):
    last = len(swarm.tellos) - 1
    heights = {}

    def form(number, drone):
        rank = min(number, last - number)
        drone.move_up(30 + STAIRS_CM * number)
        swarm.sync()  # nobody moves sidewards before all have their height
        drone.move_forward(WEDGE_CM * (rank + 1))
        swarm.sync()
        drone.rotate_clockwise(90)
        heights[number] = drone.get_distance_tof()
        swarm.sync()
        drone.rotate_counter_clockwise(90)

    swarm.takeoff()
    swarm.parallel(form)
    print("Heights above the ground in cm:", [heights[number] for number in sorted(heights)])
    swarm.land()
    print("All have landed.")


def main():
    addresses = sys.argv[1:]
    if not addresses:
        sys.exit("Which drones? Give the address of each: 192.168.10.1 192.168.10.3 ...")
    Tello.RETRY_COUNT = 1  # a refused command is refused again
    swarm = TelloSwarm.fromIps(addresses)
    swarm.connect()
    for number, drone in enumerate(swarm.tellos, 1):
        print(f"Drone {number} at {drone.address[0]}: battery {drone.get_battery()} %")
    fly(swarm)


if __name__ == "__main__":
    main()
