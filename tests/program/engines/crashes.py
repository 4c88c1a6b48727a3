"""Dies at the first line, with words."""
import sys

sys.stdin.readline()
sys.exit("assertion: no scene at all")
